#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# package_test.sh SOURCES BUILD SCRATCH: packs what is built in BUILD by debian/rules, all but the compiling, and looks at
# what a user would get.
set -euo pipefail
sources=$1 build=$2 scratch=$3
failures=0
wrong() { echo "wrong: $*" >&2 && failures=$((failures + 1)); }
same() { [ "$2" = "$3" ] || wrong "$1: $(diff <(echo "$2") <(echo "$3") | grep '^[<>]' | tr '\n' ' ')"; }

cd -- "$sources"

# One version, in all its places.
version=$(sed -n '1s/.*(\(.*\)).*/\1/p' debian/changelog)
same "the version of debian/changelog and of the program" "polhode $version" "$("$build/app/polhode" --version)"
same "the version of debian/changelog and of metainfo" "$version" \
  "$(sed -n 's/.*<release version="\([^"]*\)".*/\1/p' assets/desktop/polhode.metainfo.xml | head -n 1)"

# What is needed to build is in one list, and in debian/control, where a compiler need not be said and a package that some
# release lacks has an alternative.
# shellcheck source=assets/setup/setup.sh
listed=$(. "$sources/assets/setup/setup.sh" && packages_of play | sed 's/?$//' | grep -vx g++ | sort)
needed=$(sed -n '/^Build-Depends:/,/^$/p' debian/control |
  sed -n 's/^ \([a-z0-9][a-z0-9.+-]*\).*/\1/p' | grep -vx debhelper-compat | sort)
same "Build-Depends and [play] of packages.txt" "$listed" "$needed"

if command -v desktop-file-validate >/dev/null; then
  desktop-file-validate assets/desktop/polhode.desktop || wrong "the desktop entry"
fi
if command -v appstreamcli >/dev/null; then
  # Newer versions warn that there is no home page, and there is none.
  findings=$(appstreamcli validate --no-net assets/desktop/polhode.metainfo.xml | grep '^[EW]: ' | grep -v 'url-homepage-missing$' || true)
  same "what is wrong with the metainfo" "$findings" ""
fi

if ! command -v dh >/dev/null; then
  echo "skipped: debhelper is not installed"
  [ "$failures" -eq 0 ] || exit 1
  exit 77
fi

rm -rf -- "$scratch"
mkdir -p -- "$scratch/tree/lessons"
cp -r -- README.md CHANGELOG.md debian docs examples assets "$scratch/tree"
cp -- lessons/FORMAT.md "$scratch/tree/lessons"
cd -- "$scratch/tree"
mv debian/rules debian/real-rules
# What is built already is packed, and dwz is left out: it packs debugging information alone, and cannot read clang's.
cat >debian/rules <<RULES
#!/usr/bin/make -f
include debian/real-rules
override_dh_auto_configure override_dh_auto_build override_dh_dwz:
	@true
override_dh_builddeb:
	dh_builddeb -- -Znone
override_dh_auto_install:
	cmake --install $build --prefix debian/tmp/usr
	mkdir debian/multiarch && mv debian/tmp/usr/lib debian/multiarch/any && mv debian/multiarch debian/tmp/usr/lib
RULES
chmod +x debian/rules
debian/rules binary >"$scratch/log" 2>&1 || { tail -n 30 "$scratch/log" >&2 && exit 1; }

cd -- "$scratch"
for name in polhode libpolhode-physics-dev polhode-doc; do
  ls "${name}_${version}"_*.deb >/dev/null || wrong "no package $name"
  dpkg-deb -x "${name}_${version}"_*.deb "$scratch/$name"
done
has() { [ -s "$scratch/$1" ] || wrong "no $1"; }
for command in $(polhode/usr/bin/polhode --help | sed -n '/^Subcommands/,/^$/s/^  \([a-z]*\) .*/-\1/p') ""; do
  has "polhode/usr/share/man/man1/polhode$command.1.gz"
done
for file in share/bash-completion/completions/polhode share/zsh/vendor-completions/_polhode \
  share/fish/vendor_completions.d/polhode.fish share/applications/polhode.desktop share/metainfo/polhode.metainfo.xml \
  share/mime/packages/polhode-lesson.xml share/polhode/jobs/export.sbatch \
  share/icons/hicolor/{32x32,48x48,64x64,128x128,256x256,512x512}/apps/polhode.png; do
  has "polhode/usr/$file"
done
for library in libeigen3-dev nlohmann-json3-dev libcli11-dev libtomlplusplus-dev libimgui-dev; do
  zgrep -q "^Compiled in from Debian's package $library," polhode/usr/share/doc/polhode/NOTICES.gz ||
    wrong "no notice of the licence of $library"
done
zgrep -q 'package libeigen3-dev,' libpolhode-physics-dev/usr/share/doc/libpolhode-physics-dev/NOTICES.gz ||
  wrong "no notice of Eigen's licence"
has libpolhode-physics-dev/usr/include/polhode/method.h
has polhode-doc/usr/share/doc/polhode-doc/docs/interface.md

# What is opened at run time and what is linked to.
depends=$(dpkg-deb -f polhode_"$version"_*.deb Depends)
for package in fonts-texgyre fonts-texgyre-math 'libosmesa6 | libegl1' libglfw3 libfreetype6; do
  [[ ", $depends," == *", $package"[\ ,\(]* ]] || wrong "polhode does not depend on $package but on $depends"
done

# Unpacked anywhere, the program finds its lessons, and draws.
cd -- "$scratch/polhode/usr/share/doc"
lessons=$(env -u POLHODE_LESSONS HOME=/nonexistent "$scratch/polhode/usr/bin/polhode" list | cut -d ' ' -f 1 | sort)
same "lessons in the package and in the sources" "$(cd "$sources/lessons" && awk 'FNR == 1 && $0 == "+++" { gsub(/^\.\/|\.md$/, "", FILENAME); print FILENAME }' ./*.md | sort)" \
  "$lessons"
env -u POLHODE_LESSONS HOME=/nonexistent "$scratch/polhode/usr/bin/polhode" export euler-equations --stage poinsot \
  --what figure --size 160x120 -o "$scratch/pictures" >/dev/null || wrong "the packed program exports nothing"

[ "$failures" -eq 0 ]
