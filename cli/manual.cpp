// SPDX-License-Identifier: GPL-3.0-or-later
#include "manual.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <sstream>

#include "commands.hpp"
#include "stickslip/core/file.hpp"

namespace stickslip {
namespace {

/// Text as roff shows it: hyphens that can be copied as options, no escapes.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '\\':
        result += "\\e";
        break;
      case '-':
        result += "\\-";
        break;
      case '^':
        result += "\\(ha";
        break;
      case '~':
        result += "\\(ti";
        break;
      case '`':
        result += "\\(ga";
        break;
      default:
        result += c;
    }
  }
  return result;
}

/// A line of text: one that begins like a request is none.
std::string roff_line(const std::string& text) {
  const bool looks_like_request = !text.empty() && (text[0] == '.' || text[0] == '\'');
  return (looks_like_request ? "\\&" : "") + roff(text) + "\n";
}

std::string bold(const std::string& text) {
  return "\\fB" + roff(text) + "\\fR";
}
std::string italic(const std::string& text) {
  return "\\fI" + roff(text) + "\\fR";
}

std::string sentence(const std::string& text) {
  const bool ends = text.empty() || text.back() == '.' || text.back() == '?';
  return ends ? text : text + ".";
}

struct Footer {
  std::string description, files, examples, exit_codes;  ///< lines
};

Footer sections_of(const std::string& footer) {
  Footer sections;
  std::string* section = &sections.description;
  std::istringstream lines(footer);
  for (std::string line; std::getline(lines, line);) {
    const auto starts = [&](const std::string& head, std::string& begun) {
      if (line.rfind(head, 0) != 0) return false;
      section = &begun;
      line.erase(0, head.size());
      line.erase(0, line.find_first_not_of(' '));
      return true;
    };
    if (starts("Example:", sections.examples)) {
      if (!line.empty()) line.insert(0, "  ");  // a command, to be left as it is
    } else if (!starts("Files:", sections.files)) {
      starts("Exit codes:", sections.exit_codes);
    }
    if (!line.empty()) *section += line + "\n";
  }
  return sections;
}

std::string filled(const std::string& text) {
  std::string result;
  bool literal = false;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if ((line[0] == ' ') != literal) {
      literal = !literal;
      result += literal ? (result.empty() ? "" : ".PP\n") + std::string(".RS 4\n.EX\n")
                        : ".EE\n.RE\n.PP\n";
    }
    result += roff_line(literal ? line.substr(2) : line);
  }
  return result + (literal ? ".EE\n.RE\n" : "");
}

void write_section(std::ostream& out, const std::string& heading, const std::string& lines) {
  if (!lines.empty()) out << ".SH " << heading << '\n' << lines;
}

std::string entry_text(const OptionEntry& entry) {
  std::string name;
  for (const std::string& each : entry.names) {
    name += (name.empty() ? "" : ", ") + (each[0] == '-' ? bold(each) : italic(each));
  }
  if (entry.names.front()[0] == '-' && !entry.value.empty()) name += " " + italic(entry.value);
  std::string text = ".TP\n" + name + "\n" + roff_line(sentence(entry.description));
  const auto add = [&](const std::string& more) { text += roff_line(more); };
  if (!entry.choices.empty()) add("One of: " + joined(entry.choices, ", ") + ".");
  if (!entry.default_value.empty()) add("Default: " + entry.default_value + ".");
  if (entry.required && entry.names.front()[0] == '-') add("Required.");
  if (!entry.needs.empty()) add("Only with " + joined(entry.needs, ", ") + ".");
  if (!entry.excludes.empty()) add("Not with " + joined(entry.excludes, ", ") + ".");
  return text;
}

std::string entries_text(const std::vector<OptionEntry>& entries) {
  std::string text;
  for (const OptionEntry& entry : entries) text += entry_text(entry);
  return text;
}

std::string synopsis(const CommandEntry& command) {
  std::string text = bold(command.name) + "\n";
  for (const OptionEntry& option : command.options) {
    const std::string body =
        bold(option.names.back()) + (option.value.empty() ? "" : "\\ " + italic(option.value));
    text += (option.required ? body : "[" + body + "]") + "\n";
  }
  for (const OptionEntry& argument : command.arguments) {
    text += italic(argument.names.front()) + "\n";
  }
  if (!command.subcommands.empty()) text += italic("SUBCOMMAND") + " ...\n";
  return text;
}

std::string page_name(const CommandEntry& command) {
  std::string name = command.name;
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::string reference(const std::string& page) {
  return bold(page) + "(1)";
}

std::string page(const CommandEntry& command, const std::vector<std::string>& related) {
  const std::string name = page_name(command);
  std::string title = name;
  for (char& c : title) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  const Footer footer = sections_of(command.footer);
  std::ostringstream out;
  out << ".\\\" Written by stickslip from its own command line; do not edit.\n"
      << ".TH " << roff(title) << " 1 \"" STICKSLIP_DATE "\" \"stickslip " STICKSLIP_VERSION
      << "\" \"stickslip manual\"\n"
      << ".SH NAME\n"
      << roff(name) << " \\- " << roff_line(command.description);
  write_section(out, "SYNOPSIS", ".ad l\n.hy 0\n" + synopsis(command) + ".hy\n.ad\n");
  write_section(out, "DESCRIPTION",
                filled(sentence(command.description) + "\n" + footer.description));
  write_section(out, "ARGUMENTS", entries_text(command.arguments));
  std::string subcommands;
  for (const CommandEntry& subcommand : command.subcommands) {
    subcommands += ".TP\n" + reference(page_name(subcommand)) + "\n" +
                   roff_line(sentence(subcommand.description));
  }
  write_section(out, "SUBCOMMANDS", subcommands);
  write_section(out, "OPTIONS", entries_text(command.options));
  write_section(out, "EXIT STATUS", filled(footer.exit_codes));
  write_section(out, "FILES", filled(footer.files));
  write_section(out, "EXAMPLES", filled(footer.examples));
  std::string others;
  for (const std::string& other : related) {
    if (other != name) others += (others.empty() ? "" : ",\n") + reference(other);
  }
  write_section(out, "SEE ALSO", others + "\n");
  return out.str();
}

void add_pages(const CommandEntry& command, std::vector<std::string> above,
               std::map<std::string, std::string>& pages) {
  above.push_back(page_name(command));
  std::vector<std::string> related = above;
  for (const CommandEntry& subcommand : command.subcommands) {
    related.push_back(page_name(subcommand));
    add_pages(subcommand, above, pages);
  }
  related.emplace_back("stickslip-check");
  std::sort(related.begin(), related.end());
  pages[page_name(command) + ".1"] = page(command, related);
}

}  // namespace

std::map<std::string, std::string> manual_pages(const CommandEntry& tree) {
  std::map<std::string, std::string> pages;
  add_pages(tree, {}, pages);
  return pages;
}

void add_manual_command(CLI::App& app, int& exit_code) {
  auto folder = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("manual", "Write the pages of the manual into a folder")->group("");
  command->add_option("DIR", *folder, "Folder to write to")->type_name("DIR")->required();
  command->callback([&app, folder, &exit_code] {
    for (const auto& [name, text] : manual_pages(command_tree(app))) {
      write_whole_file((std::filesystem::path(*folder) / name).string(), text);
    }
    exit_code = kDone;
  });
}

}  // namespace stickslip
