#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# manual.sh STICKSLIP FOLDER: a manual page for each command, made by help2man from its --help.
set -euo pipefail
PATH=$(cd "$(dirname "$1")" && pwd):$PATH  # help2man takes no path with blanks
folder=$2
version=$(stickslip --version)
# As mandoc wants it; help2man's own says only the month.
date=$(date -u -d "@${SOURCE_DATE_EPOCH:-$(date +%s)}" +%F)
mkdir -p "$folder"
rm -f "$folder"/*.1

# commands_below WORD...: the names in the help of `stickslip WORD...`.
commands_below() {
  stickslip "$@" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\+\) .*/\1/p'
}

# write_pages WORD...: of `stickslip WORD...` and of what is below it.
write_pages() {
  local page command
  page=$(IFS=-; echo "stickslip${*:+-$*}")
  printf '[see also]\n.BR stickslip (1),\n.BR stickslip\\-check (1)\n' |
    help2man --no-info --name "$(stickslip "$@" --help | head -n 1)" --source "$version" \
      --version-string "$page ${version#* }" --manual "stickslip manual" \
      --include - --output "$folder/$page.1" "stickslip${*:+ $*}"
  sed -i "/^\.TH/s/ \"1\" \"[^\"]*\"/ \"1\" \"$date\"/" "$folder/$page.1"
  for command in $(commands_below "$@"); do write_pages "$@" "$command"; done
}

write_pages
