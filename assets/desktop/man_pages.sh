#!/usr/bin/env bash
# man_pages.sh PROGRAM FOLDER: a manual page for the program and one for each command, from their --help.
set -euo pipefail
program=$1
folder=$2
version=$("$program" --version)
version=${version#* }
commands=$("$program" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\)  *\(.*\)/\1 \2/p')

# page NAME WORDS ABOUT SEE-ALSO...
page() {
    printf '[see also]\n%s\n' "$(printf '.BR %s (1)\n' "${@:4}")" |
        help2man --no-info --name="$3" --version-string="$1 $version" --include=/dev/stdin --output="$folder/$1.1" "$2"
    gzip --best --no-name --force "$folder/$1.1"
}

mkdir -p "$folder"
pages=()
while read -r command about; do
    page "shading-sandbox-$command" "'$program' $command" "${about%.}" shading-sandbox
    pages+=("shading-sandbox-$command")
done <<<"$commands"
about=$("$program" --help | sed -n 1p)
page shading-sandbox "'$program'" "${about%.}" "${pages[@]}"
