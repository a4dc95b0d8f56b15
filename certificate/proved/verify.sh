#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Has Coq check all proofs of this folder anew, and its second checker, coqchk, what they became;
# compares the program that Coq extracts with the one in extracted/; and prints the theorems and
# what they assume, which may be the axioms of Coq's real numbers and nothing else. About two
# minutes. On Debian: apt-get install coq
#   verify.sh               all of it; then writes into verified.sha256 what it was of
#   verify.sh --if-changed  nothing if verified.sha256 names these files and this Coq, unless
#                           STICKSLIP_PROVE_ANEW is set (to anything); writes nothing
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# Coq.Reals: excluded middle for some predicates, and functions that agree everywhere are equal.
allowed='ClassicalDedekindReals.sig_not_dec
ClassicalDedekindReals.sig_forall_dec
FunctionalExtensionality.functional_extensionality_dep
functional_extensionality_dep'

command -v coqc >/dev/null || { echo "verify.sh: there is no coqc; on Debian: apt-get install coq" >&2; exit 2; }
# Coq, and what it reads or is compared with: this script is part of it.
now() {
  echo "$(coqc --print-version | cut -d ' ' -f 1)  coqc"
  (cd "$here" && LC_ALL=C sha256sum verify.sh ./*.v extracted/*)
}
case "${1-}" in
  "") ;;
  --if-changed)
    if [ -z "${STICKSLIP_PROVE_ANEW-}" ] && now | cmp -s - "$here/verified.sha256"; then
      echo "Nothing changed since all of it was checked; verify.sh checks it anew."
      exit 0
    fi ;;
  *) echo "verify.sh: unknown argument '$1'; none, or --if-changed" >&2; exit 2 ;;
esac
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp "$here"/*.v "$folder"
cd "$folder"
mkdir extracted

for file in $(coqdep -R . Proved -sort ./*.v); do
  coqc -q -R . Proved "$file" >"$file.said"
done
# An unfinished proof would be an axiom below; this names its file.
if grep -nE '\b(Admitted|admit|Axiom|Parameter|Conjecture)\b' ./*.v; then
  echo "verify.sh: there is something unproved" >&2
  exit 1
fi
diff -r extracted "$here/extracted" || { echo "verify.sh: extracted/ is not what Coq extracts; copy it from there" >&2; exit 1; }
echo "The program in extracted/ is what Coq extracts."

cat ./Assumptions.v.said ./Judge.v.said
# After "Axioms:" the names of axioms begin lines, with their types or followed by them.
for said in ./Assumptions.v.said ./Judge.v.said; do
  sed '1,/^Axioms:/d' "$said" | grep -oE '^[A-Za-z_][A-Za-z_.0-9]*' |
    while read -r axiom; do
      grep -qxF "$axiom" <<<"$allowed" || { echo "verify.sh: $axiom is assumed" >&2; exit 1; }
    done
done
echo "coqchk (its axioms are those of all libraries that are loaded):"
coqchk -silent -o -R . Proved Proved.Assumptions Proved.Judge
if [ -z "${1-}" ]; then now >"$here/verified.sha256"; fi
