#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Links of the manual's pages, README and similar files have existing targets; none needs a network.
#   test_links.bash PROJECT_DIR HTML_DIR
set -u
failures=0
fault() { echo "$1"; failures=$((failures + 1)); }

for page in "$1"/*.md; do
  for link in $(grep -oE '\]\([^)]*\)' "$page" | sed 's/^](//; s/)$//; s/#.*//' | grep -v '^http'); do
    [[ -e $1/$link ]] || fault "$(basename "$page"): $link is not there"
  done
  # Files named in backquotes, if the name begins with a directory of the project and has no placeholder.
  for name in $(grep -oE '`(include|doc|examples|test|benchmark|cmake|packaging|\.github|\.ci)/[A-Za-z0-9_./-]*`' "$page" | tr -d '`'); do
    [[ $name == *...* || $name == *NAME* || -e $1/$name ]] || fault "$(basename "$page"): $name is not there"
  done
done

cd "$2" || exit 1
targets=$(mktemp)
links=$(mktemp)
trap 'rm "$targets" "$links"' EXIT
grep -oE '(id|name)="[^"]+"' ./*.html | sed -E 's/^\.\/([^:]*):[a-z]*="(.*)"$/\1#\2/' > "$targets"
ls >> "$targets"
grep -oE '(href|src)="[^"]+"' ./*.html | grep -vE '="(javascript:|mailto:|https?://(www\.doxygen\.org|[a-z.]*cgal\.org))' |
  sed -E 's/^\.\/([^:]*):[a-z]*="#(.*)"$/\1 \1#\2/; s/^\.\/([^:]*):[a-z]*="(.*)"$/\1 \2/' | sort -u > "$links"
while read -r page link; do
  grep -qxF -- "$link" "$targets" || [[ $link != *#* && -e $link ]] || fault "$page: $link is not there"
done < <(awk 'NR == FNR { known[$0]; next } !($2 in known)' "$targets" "$links")
[[ $(wc -l < "$links") -gt 500 ]] || fault "only $(wc -l < "$links") links were found"
echo "$(wc -l < "$links") links of the manual, $failures faults"
exit $((failures > 0))
