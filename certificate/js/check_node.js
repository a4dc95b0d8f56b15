#!/usr/bin/env node
// SPDX-License-Identifier: MIT
//
// check.js for the command line: arguments, answers and exit codes of stickslip-check.
'use strict';

const fs = require('fs');
const {check} = require('./check.js');

const HELP = `check_node.js GRASP CERTIFICATE [options]

Checks a stickslip certificate with the checker of the page, certificate/js/check.js. Arguments, answers and exit
codes are those of stickslip-check; see certificate/FORMAT.md.

  --wrench WX,WY,T         wrench applied to the object; in space WX,WY,WZ,TX,TY,TZ; of several bodies a
                           number for each coordinate, as in --direction
  --torque T               short for --wrench 0,0,T
  --case NAME              the wrench of this case of the grasp file
  --preload P              one preload for all contacts
  --normal-law LAW         unilateral (the default) or bilateral
  --direction WX,WY,T      ask for the margin along a wrench; in space WX,WY,WZ,TX,TY,TZ
  --preload-direction D    ask for the margin along preloads: P0,P1,..., or the word scale
  --plane UX,UY,UT,VX,VY,VT
                           ask for the region of a plane of wrenches: not judged
  --inertia X,Y,G2         ask for the class of rigid contacts: not judged
  --uncertain LIST         such as friction=10%,position=0.001: ask about every grasp in the box; or, about
                           every load in a ball, wrench=ball:R[:length=L][:about=X:Y[:Z]][:body=NAME]
  --max-motion LENGTH,ANGLE
                           ask about motions up to these alone; or a number for each coordinate; or none
  --json                   answer as one JSON object
  --batch                  instead of two files, questions from standard input: on each line a JSON object
                           {"grasp": TEXT, "certificate": TEXT, "options": [WORD, ...]}, of which each character
                           stands for the byte of its number; each is answered by a line, as with --json
  -h, --help               this text, if it comes before GRASP
  --                       no options follow
`;

class Usage extends Error {}

// As check.js takes them. A number has at least a digit; whether it is one is found out later, but for usage.
const NUMBER = /^[+-]?[0-9]+(?:\/[0-9]+|(?:\.[0-9]+)?(?:[eE][+-]?[0-9]+)?)$/;

function numbers(text, lengths, what, most = Infinity) {
  const list = text.split(',');
  if (!list.every((x) => NUMBER.test(x)) || (lengths !== null && !lengths.includes(list.length)) || list.length > most) {
    throw new Usage(`${shown(text)} is not ${what}`);
  }
  return list;
}

const WRENCH = 'WX,WY,T, such as 0,-11/10,0, or as many numbers as the grasp has coordinates, at most 30';
const OPTIONS = {
  '--wrench': (o, text) => { o.wrench = numbers(text, null, WRENCH, 30); },
  '--torque': (o, text) => { o.wrench = ['0', '0', ...numbers(text, [1], 'a number')]; },
  '--case': (o, text) => { o.case = text; },
  '--preload': (o, text) => { [o.preload] = numbers(text, [1], 'a number'); },
  '--normal-law': (o, text) => {
    if (text !== 'unilateral' && text !== 'bilateral') throw new Usage(`${shown(text)} is not unilateral or bilateral`);
    o.normal_law = text;
  },
  '--direction': (o, text) => { o.direction = numbers(text, null, WRENCH, 30); },
  '--preload-direction': (o, text) => {
    o.preload_direction = text === 'scale' ? text : text === '' ? (() => { throw new Usage('no number'); })()
      : numbers(text, null, 'P0,P1,... or scale');
  },
  '--plane': (o, text) => { o.plane = numbers(text, [6], 'UX,UY,UT,VX,VY,VT, two wrenches'); },
  '--inertia': (o, text) => { o.inertia = numbers(text, [3, 6, 9], 'X,Y,G2'); },
  '--uncertain': (o, text) => {
    o.uncertain = {};
    for (const one of text.split(',')) {
      const [, kind, tolerance] = /^([a-z]+)=(.*)$/s.exec(one) ?? [];
      const kinds = ['friction', 'stiffness', 'preload', 'position', 'normal', 'wrench'];
      if (!kinds.includes(kind) || kind in o.uncertain ||
          !(NUMBER.test(tolerance.replace(/%$/, '')) || (kind === 'wrench' && tolerance.startsWith('ball:')))) {
        throw new Usage(`${shown(text)} is not KIND=T,... of ${kinds.join(', ')}`);
      }
      o.uncertain[kind] = tolerance;
    }
  },
  '--max-motion': (o, text) => {
    o.max_motion = text === 'none' ? text : numbers(text, null, 'LENGTH,ANGLE, or a number for each coordinate, at most 30, or none', 30);
  },
};

/** Printable ASCII: nothing that a file or its name says reaches a terminal otherwise. */
const shown = (text) => `"${printed(text)}"`;
const printed = (text) => String(text).replace(/[^\x20-\x7e]/gu, (c) => `\\u{${c.codePointAt(0).toString(16)}}`);

function parse_arguments(words) {
  const result = {files: [], options: {}, json: false, batch: false, help: false};
  let only_files = false;
  for (let k = 0; k < words.length; ++k) {
    const word = words[k];
    if (only_files || word === '-' || !word.startsWith('-')) {
      result.files.push(word);
    } else if (word === '--') {
      only_files = true;
    } else if (word === '-h' || word === '--help') {
      if (result.files.length === 0) return {...result, help: true};
      result.files.push(word);  // a file's name must not make the exit code 0
    } else if (word === '--json') {
      result.json = true;
    } else if (word === '--batch') {
      result.batch = true;
    } else {
      const at = word.indexOf('='), name = at < 0 ? word : word.slice(0, at);
      if (!Object.hasOwn(OPTIONS, name)) throw new Usage(`unknown option ${shown(word)}`);
      if (at < 0 && ++k === words.length) throw new Usage(`${name} needs a value`);
      try {
        OPTIONS[name](result.options, at < 0 ? words[k] : word.slice(at + 1));
      } catch (error) {
        throw error instanceof Usage ? new Usage(`${name}: ${error.message}`) : error;
      }
    }
  }
  if (!result.batch && result.files.length !== 2) {
    throw new Usage(`expected two files, GRASP and CERTIFICATE, found ${result.files.length}`);
  }
  if (result.files[0] === '-' && result.files[1] === '-') throw new Usage('both files are standard input');
  return result;
}

/** As stickslip-check --json has it. */
function report_of(answer) {
  const path = answer.answer !== 'malformed' ? answer.place
    : [answer.file === 'question' ? '' : answer.file, answer.place].filter((x) => x !== '').join(': ') || answer.file;
  return {result: answer.answer, rule: answer.rule, node: answer.node, path, found: answer.found, verdict: answer.verdict,
    box: answer.box, nodes: answer.nodes, leaves: answer.leaves, resisted: answer.resisted, refuted: answer.refuted,
    question: answer.question};
}

// As Python and C++ write it: a space after each comma and colon; ASCII.
function json_text(value) {
  if (Array.isArray(value)) return `[${value.map(json_text).join(', ')}]`;
  if (value !== null && typeof value === 'object') {
    return `{${Object.entries(value).map(([key, one]) => `${json_text(key)}: ${json_text(one)}`).join(', ')}}`;
  }
  return JSON.stringify(value).replace(/[^\x20-\x7e]/g, (c) => `\\u${c.charCodeAt(0).toString(16).padStart(4, '0')}`);
}

const ball_text = ({ball, length, about, body}) =>
  `ball:${ball}, length ${length}, about (${about.join(', ')})${body === undefined ? '' : `, on the body ${shown(body)}`}`;

function accepted_text(answer) {
  const {question, proof, verdict, resisted, refuted} = answer;
  const tuple = (list) => `(${list.map((x) => (Array.isArray(x) ? `[${x.join(', ')}]` : x)).join(', ')})`;
  const union = (list, none, text) => (list.length === 0 ? none : list.map(text).join(', '));
  const trees = `${proof.nodes} nodes: ${proof.leaves} leaves`;
  const rows = [];
  if (verdict === 'margin') {
    rows.push(['resisted', union(resisted, refuted === null ? 'no multiple' : 'none claimed', ([low, high]) => (high === null ? `[${low}, oo)` : `[${low}, ${high}]`))]);
    if (refuted !== null) {
      rows.push(['refuted', union(refuted, 'none claimed', ([low, high, closed]) => `${closed ? '[' : '('}${low}, ${high ?? 'oo'})`)],
          ['elsewhere', 'nothing is claimed']);
    }
  } else {
    rows.push(['verdict', verdict + (answer.box ? ', for every grasp in the box' : '')]);
  }
  rows.push(['contacts', question.contacts], ['wrench', tuple(question.wrench)]);
  if (question.direction !== null) rows.push(['direction', tuple(question.direction)]);
  const own = question.preload === null ? 'as in the grasp file' : `${question.preload} at all contacts`;
  const growth = question.preload_direction;
  rows.push(['preload', growth === 'scale' ? `f times ${own}` : growth === null ? own : `${own} + f ${tuple(growth)}`]);
  rows.push(['normal law', question.normal_law]);
  if (question.uncertain !== null) {
    rows.push(['uncertain', Object.entries(question.uncertain).map(([kind, t]) => `${kind} ${typeof t === 'string' ? t : ball_text(t)}`).join(', ')]);
  }
  if (question.max_motion !== undefined) rows.push(['max motion', tuple(question.max_motion)]);
  rows.push(['proof', verdict === 'margin' ? (refuted === null ? `segments: ${proof.segments}; trees: ${proof.trees}, of ${trees}`
      : `intervals by degree: ${proof.degrees}${proof.rests > 0 ? `, at rest: ${proof.rests}` : ''}${
        proof.stickings > 0 ? `, sticking: ${proof.stickings}` : ''}, refuted: ${proof.trees}; trees of ${trees}`)
    : proof.rests + proof.stickings + proof.degrees > 0 ? [...(proof.rests > 0 ? [`at rest, parts: ${proof.rests}`] : []),
      ...(proof.stickings > 0 ? [`sticking, parts: ${proof.stickings}`] : []),
      ...(proof.degrees > 0 ? [`by degree, parts: ${proof.degrees}; trees of ${trees}`] : [])].join('; ')
      : answer.nodes === null ? 'an equilibrium' : `a tree of ${trees}`]);
  return 'accepted\n' + rows.map(([name, value]) => `${name.padEnd(11)} ${value}\n`).join('');
}

function rejected_text({rule, node, place, found}) {
  const rows = [['rule', rule], ['node', node], ['path', place], ['found', found]];
  return 'rejected\n' + rows.filter(([, value]) => value !== null).map(([name, value]) => `${name.padEnd(6)} ${value}\n`).join('');
}

function read_file(name) {
  if (name !== '-' && fs.statSync(name).isDirectory()) throw new Error('it is a directory');
  return fs.readFileSync(name === '-' ? 0 : name);
}

/** Everything at once, whatever pipe it goes through. */
function write(stream, text) {
  const bytes = Buffer.from(text);
  for (let at = 0; at < bytes.length;) {
    try {
      at += fs.writeSync(stream, bytes, at);
    } catch (error) {
      if (error.code !== 'EAGAIN') throw error;
    }
  }
}

function batch() {
  const buffer = Buffer.alloc(1 << 20);
  let rest = '';
  for (;;) {
    let size = 0;
    try {
      size = fs.readSync(0, buffer);
    } catch (error) {
      if (error.code === 'EAGAIN') continue;
      if (error.code !== 'EOF') throw error;
    }
    if (size === 0) return 0;
    const lines = (rest + buffer.toString('latin1', 0, size)).split('\n');
    rest = lines.pop();
    for (const line of lines) {
      let report;
      try {
        const question = JSON.parse(line);
        const bytes = (text) => Buffer.from(text, 'latin1');
        const {options} = parse_arguments(['g', 'c', ...question.options]);
        report = report_of(check(bytes(question.grasp), bytes(question.certificate), options));
      } catch (error) {
        report = {result: 'failed', rule: null, node: null, path: null, found: printed(error.stack)};
      }
      write(1, json_text(report) + '\n');
    }
  }
}

function main(words) {
  const fail = (text) => {
    try {
      write(2, `check_node.js: ${text}\n`);
    } catch (error) {
      // That nobody can read why changes no exit code.
    }
    return 2;
  };
  try {
    const given = parse_arguments(words);
    if (given.help) {
      write(1, HELP);
      return 0;
    }
    if (given.batch) return batch();
    const contents = [];
    let answer = null;
    for (const name of given.files) {
      try {
        contents.push(read_file(name));
      } catch (error) {
        const found = error.code === 'ENOENT' ? 'No such file or directory' : printed(error.message);
        answer = {answer: 'malformed', rule: null, node: null, place: 'opening', found, verdict: null, box: null,
          nodes: null, leaves: null, resisted: null, refuted: null, question: null, file: name};
        break;
      }
    }
    if (answer === null) {
      answer = check(...contents, given.options);
      const k = ['grasp', 'certificate'].indexOf(answer.file);
      if (k >= 0) answer.file = given.files[k] === '-' ? '<stdin>' : given.files[k];
    }
    if (given.json) write(1, json_text(report_of(answer)) + '\n');
    if (answer.answer === 'malformed') {
      if (given.json) return 2;
      return fail([answer.file === 'question' ? '' : printed(answer.file), printed(answer.place), printed(answer.found)]
          .filter((x) => x !== '').join(': '));
    }
    const codes = {accepted: 0, rejected: 1, 'not judged': 3};
    if (!given.json) {
      write(1, answer.answer === 'accepted' ? accepted_text(answer)
        : answer.answer === 'rejected' ? rejected_text(answer) : `not judged\nwhy    ${answer.found}\n`);
    }
    return codes[answer.answer];
  } catch (error) {
    if (error instanceof Usage) return fail(`${error.message}; try check_node.js --help`);
    if (error.code === 'EPIPE') return 2;
    if (error.code === 'ENOSPC') return fail('standard output: No space left on device');
    return fail(`internal error: ${printed(error.stack)}`);
  }
}

process.exitCode = main(process.argv.slice(2));
