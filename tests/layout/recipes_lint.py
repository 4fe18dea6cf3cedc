#!/usr/bin/env python3
"""What the recipes of CONTRIBUTING.md ask to be named in a list stands in it. A compiler finds an entry without its answers, not
an entry that nobody lists. usage: recipes_lint.py SOURCE_FOLDER"""
import pathlib
import re
import sys

source = pathlib.Path(sys.argv[1])
faults, found = [], {}


def must_stand_in(recipe, list_file, pattern, files, in_list=r"\b{}\b"):
    """Each name that the pattern finds in the files stands in the list, as in_list says."""
    text = (source / list_file).read_text()
    for file in sorted(files):
        for name in re.findall(pattern, file.read_text(), re.MULTILINE):
            found.setdefault(recipe, []).append(name)
            if not re.search(in_list.format(re.escape(name)), text):
                faults.append(f"{file.relative_to(source)}: the {recipe} '{name}' does not stand in {list_file}")


def reached(folder, file, seen):
    """Files of a folder that one of them includes, itself among them."""
    if file not in seen and (source / folder / file).is_file():
        seen.add(file)
        for other in re.findall(rf'^#include "{folder}/([^"/]+)"', (source / folder / file).read_text(), re.MULTILINE):
            reached(folder, other, seen)
    return seen


laws, loads, cli = (source / folder for folder in ("membrane/laws", "membrane/loads", "compare/cli"))
must_stand_in("law", "membrane/laws/list.hpp", r"LawForm<(\w+)>> forms\(\);", laws.glob("*.hpp"), r"using Law =[^;]*\b{}\b")
must_stand_in("load", "membrane/loads/list.hpp", r"^struct (\w+) \{(?=(?:(?!^\};)[\s\S])* action\(\) const)",
              loads.glob("*.hpp"), r"using Load =[^;]*\b{}\b")
must_stand_in("command", "compare/cli/main.cpp", r"^void (add_\w+)\(CLI::App& app, int& exit_code\);", cli.glob("*.hpp"),
              r'Command\{{"\w+", validate::{}\}}')
must_stand_in("figure", "compare/figures/list.cpp", r"^PaperFigure (\w+)\(const FigureContext&", (source / "compare/figures").glob("*.cpp"))
must_stand_in("format", "compare/instruments/list.cpp", r"^extern const InstrumentFormat (\w+);",
              (source / "compare/instruments").glob("*.hpp"), r"formats = \{{[^;]*\b{}\b")

models = "compare/fitting/models"
for header in {path.name for path in (source / models).glob("*.hpp")} - reached(models, "list.cpp", set()):
    faults.append(f"{models}/{header}: nothing that list.cpp lists uses this closed form")
found["closed form"] = sorted(reached(models, "list.cpp", set()) - {"list.cpp", "list.hpp"})

for recipe in ("law", "load", "command", "figure", "format", "closed form"):
    if len(found.get(recipe, [])) < 2:
        faults.append(f"no {recipe} is found any more: this check looks for another form of it")
print("\n".join(faults) or ", ".join(f"{len(names)} {recipe}s" for recipe, names in found.items()))
sys.exit(bool(faults))
