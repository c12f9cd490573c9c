#!/usr/bin/env bash
# Puts what the page is built with into FOLDER: Emscripten, which Debian 12 has too old, so that Debian 13's is unpacked
# there and runs on this system's Clang 19; and the sources of the libraries, for Debian has none built for WebAssembly.
# apt works on lists of its own in FOLDER; the system's are left as they are.
#   third_party/web_tools.sh FOLDER
set -euo pipefail

folder=$(realpath -m "$1")
done_mark=$folder/complete-2 # the number goes up when what is put here changes
[[ -f $done_mark ]] && exit 0
rm -rf "$folder"
mkdir -p "$folder/bin" "$folder/sources" "$folder/packages"

# The archive that the system's own source list names first.
read -r site codename < <(apt-get indextargets --format '$(SITE) $(CODENAME)' 'Created-By: Packages' 'Component: main') || {
    echo "web_tools.sh: there is no Debian archive among apt's sources" >&2
    exit 1
}

# apt_in NAME LINE COMMAND...: apt-get with no source but LINE.
apt_in() {
    local state=$folder/apt-$1 line=$2
    shift 2
    if [[ ! -d $state ]]; then
        mkdir -p "$state/lists/partial" "$state/archives/partial"
        : >"$state/status"
        echo "$line" >"$state/sources.list"
        cat >"$state/apt.conf" <<CONFIG
Dir::State "$state";
Dir::State::status "$state/status";
Dir::Cache "$state";
Dir::Etc::sourcelist "$state/sources.list";
Dir::Etc::sourceparts "-";
APT::Sandbox::User "$(id -un)";
CONFIG
        APT_CONFIG=$state/apt.conf apt-get -qq update
    fi
    APT_CONFIG=$state/apt.conf apt-get -qq "$@"
}

echo "Fetching the sources of the page's libraries" >&2
cd "$folder/sources"
apt_in sources "deb-src $site $codename main" source --download-only fmtlib imgui libjpeg-turbo libspng zlib 2>"$folder/apt.log" || {
    echo "web_tools.sh: $site has not all of them; run this again later, or name another archive in apt's sources:" >&2
    grep '^E:' "$folder/apt.log" >&2
    exit 1
}
for description in *.dsc; do
    name=${description%%_*}
    dpkg-source --no-check -x "$description" "$name" >/dev/null
done

emscripten=/usr/share/emscripten
if [[ ! -f $emscripten/emscripten-version.txt ]] || ! grep -qE '^(3\.1\.[5-9][0-9]|[4-9])' $emscripten/emscripten-version.txt; then
    echo "Fetching Emscripten (240 MB)" >&2
    cd "$folder/packages"
    apt_in emscripten "deb $site trixie main" download emscripten binaryen libc6 libstdc++6 libgcc-s1
    for package in *.deb; do
        dpkg -x "$package" "$folder/root"
    done
    rm -- *.deb
    emscripten=$folder/root$emscripten
    # Its binaries want a newer C library than the system's: each is started by the loader that came with it.
    libraries=$(dirname "$(find "$folder/root/usr/lib" -name libbinaryen.so)")
    loader=$(find "$folder/root" -name 'ld-linux-*.so.*' | head -n 1)
    for program in "$folder"/root/usr/bin/wasm-*; do
        printf '#!/bin/sh\nexec "%s" --library-path "%s" "%s" "$@"\n' "$loader" "$libraries" "$program" \
            >"$folder/bin/${program##*/}"
    done
    chmod +x "$folder"/bin/*
    mkdir -p "$emscripten/node_modules"
    ln -sfn /usr/share/nodejs/acorn "$emscripten/node_modules/acorn"
    binaryen=$folder
else
    binaryen=/usr
fi
# A cache that can be written: its libraries are the package's.
mkdir -p "$folder/cache"
cp -rs "$emscripten/cache/sysroot" "$folder/cache/sysroot"
cp "$emscripten/cache/sysroot_install.stamp" "$folder/cache/"
cat >"$folder/config" <<CONFIG
LLVM_ROOT = '/usr/bin'
BINARYEN_ROOT = '$binaryen'
NODE_JS = '$(command -v node)'
LLVM_ADD_VERSION = '19'
CLANG_ADD_VERSION = '19'
CACHE = '$folder/cache'
CONFIG
ln -sfn "$emscripten" "$folder/emscripten"
touch "$done_mark"
