#!/usr/bin/env bash
# Installs Debian packages that are missing: those that the build needs (packages.txt) and those of the
# lists that are named: scripts/install-packages.sh [list]...
set -euo pipefail
cd "$(dirname "$0")/.."
for list in packages.txt "$@"; do
    [ -r "$list" ] || { echo "$list: no such list of packages" >&2; exit 2; }
done
missing=()
while read -r package; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q '^install ok installed' ||
        missing+=("$package")
done < <(cat packages.txt "$@")
[ ${#missing[@]} -eq 0 ] && exit 0
echo "installing: ${missing[*]}"
sudo=()
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "needs root or sudo to install: ${missing[*]}" >&2; exit 1; }
    sudo=(sudo)
fi
export DEBIAN_FRONTEND=noninteractive
"${sudo[@]}" apt-get update -q
"${sudo[@]}" apt-get install -q -y --no-install-recommends "${missing[@]}"
