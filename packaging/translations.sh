#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# Brings the texts of the sources into resources/translations/*.ts: new ones come unfinished, those that are gone leave.
# With a folder as argument it writes copies there instead, and leaves the repository alone.
set -eu
cd "$(dirname "$0")/.."

lupdate=""
for place in /usr/lib/qt6/bin/lupdate "$(command -v lupdate6 || true)" "$(command -v lupdate || true)"; do
  if [ -x "$place" ]; then lupdate="$place"; break; fi
done
if [ -z "$lupdate" ]; then
  echo "There is no lupdate of Qt 6. Run packaging/dependencies.sh." >&2
  exit 1
fi

to="resources/translations"
if [ $# -gt 0 ]; then
  cp "$to"/*.ts "$1/"
  to="$1"
fi
# Labels and helps of fields stand in core's rows, which the schema of projects holds; core's messages where it says them.
cli=${HYGROLOOM_CLI:-build/release/bin/hygroloom-cli}
if [ ! -x "$cli" ]; then
  echo "$cli is not there; build it with packaging/build.sh, or name it with HYGROLOOM_CLI=." >&2
  exit 1
fi
rows=$(mktemp -d)
trap 'rm -rf "$rows"' EXIT
"$cli" reference --as schema | python3 -c '
import json, pathlib, re, sys
texts, messages = set(), set()
def look(part):
    if isinstance(part, dict) and isinstance(part.get("title"), str) and ("minimum" in part or "enum" in part or "anyOf" in part or "exclusiveMinimum" in part):
        texts.update([part["title"], part.get("description", part["title"])])
    for each in part.values() if isinstance(part, dict) else part if isinstance(part, list) else []:
        look(each)
look(json.load(sys.stdin))
literal = r"\"(?:[^\"\\]|\\.)*\""
for path in [*pathlib.Path("core").rglob("*.cpp"), *pathlib.Path("core").rglob("*.h")]:
    messages.update(re.findall(r"\bsay\(\s*((?:" + literal + r"\s*)+)", path.read_text()))
names = [line for line in pathlib.Path("resources/translations/core_words.txt").read_text().splitlines() if line and not line.startswith("#")]
messages.update(json.dumps(name, ensure_ascii=False) for name in names)
print("const char* messages[] = {" + ", ".join("QT_TRANSLATE_NOOP(\"core\", %s)" % each for each in sorted(messages)) + "};")
print("const char* texts[] = {" + ", ".join("QT_TRANSLATE_NOOP(\"core\", %s)" % json.dumps(text, ensure_ascii=False) for text in sorted(texts)) + "};")
' > "$rows/fields.cpp"
# From the root, so that lupdate finds the headers that say of which class a text is.
# Functions named tr outside of classes take the context hygroloom, which is no class: lupdate says so each time.
if ! said=$("$lupdate" -silent -I . app ui "$rows/fields.cpp" -no-obsolete -locations none -no-ui-lines -ts "$to"/*.ts 2>&1); then
  echo "$said" >&2
  exit 1
fi
echo "$said" | grep -v -e "lacks Q_OBJECT macro" -e '^$' >&2 || true
unfinished=$(cat "$to"/*.ts | grep -c 'type="unfinished"' || true)
if [ "$unfinished" -gt 0 ]; then
  echo "$unfinished texts wait for their translation: grep -B2 'type=\"unfinished\"' $to/*.ts"
fi
