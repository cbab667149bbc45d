# SPDX-License-Identifier: BSD-3-Clause
"""Writes the type stubs of the wrapped filters, from the signatures in their docstrings.

Usage: make_stubs.py FILE.pyi MODULE FILE.so [MODULE FILE.so]..., the others being modules of the package that the
first needs. The package around them is not imported, so that no more is needed than VTK. VTK's own generator, which Debian's packages leave out, does the same for VTK.
"""

import importlib
import importlib.util
import inspect
import re
import sys

# Of a docstring: "Name(self, value:int, pair:(int, int)) -> str".
SIGNATURE = re.compile(r"^(\w+)\((.*)\)(?: -> (.+))?$")
VTK_MODULES = ("vtkCommonCore", "vtkCommonDataModel", "vtkCommonExecutionModel", "vtkIOCore",
               "vtkRenderingCore", "vtkRenderingOpenGL2", "vtkInteractionWidgets")
# What the wrapper calls by Python's own names.
PLAIN = {"int", "float", "bool", "str", "bytes", "None", "object", "type", "Any", "Callable", "Buffer"}


def signatures(doc):
    """The Python signatures of a docstring, each before its C++ one."""
    text = re.sub(r"\n {4,}", " ", doc or "")
    lines = text.split("\n")
    return [line for line, after in zip(lines, lines[1:] + [""])
            if SIGNATURE.match(line) and after.startswith("C++:")]


def split(text):
    """At the commas outside of brackets."""
    parts, depth = [""], 0
    for character in text:
        depth += (character in "([") - (character in ")]")
        if character == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += character
    return [part.strip() for part in parts if part.strip()]


class Stubs:
    """The text of a stub file, and what it needs of other modules."""

    def __init__(self, module, others):
        self.module = module
        self.others = others
        self.imports = {}
        self.classes = [value for _, value in inspect.getmembers(module, inspect.isclass)]
        self.names = {class_.__name__ for class_ in self.classes}

    def type_of(self, text, takes):
        """A type as the wrapper writes it: "(int, int)", "[int, ...]", "vtkPolyData"."""
        text = text.strip()
        if text[:1] in "([" and text[-1:] in ")]":
            inner = split(text[1:-1])
            if takes:
                kinds = sorted({self.type_of(kind, takes) for kind in inner if kind != "..."})
                return "Sequence[Any]" if len(kinds) != 1 else f"Sequence[{kinds[0]}]"
            return "Tuple[" + ", ".join(kind if kind == "..." else self.type_of(kind, takes)
                                        for kind in inner) + "]"
        union = [self.name(word.strip()) for word in text.split("|")]
        return union[0] if len(union) == 1 else f"Union[{', '.join(union)}]"

    def name(self, word):
        if word in PLAIN - {"object", "Callable", "Buffer"} or word in self.names:
            return word
        if word.split(".")[0] in self.names:
            return "int"  # enumerations are
        for other in self.others:
            if hasattr(other, word):
                self.imports.setdefault(f".{other.__name__.split('.')[-1]}", set()).add(word)
                return word
        for module in VTK_MODULES:
            if re.fullmatch(r"vtk\w+", word) and hasattr(self.vtk(module), word):
                self.imports.setdefault(f"vtkmodules.{module}", set()).add(word)
                return word
        return "Any"

    def vtk(self, module):
        try:
            return importlib.import_module("vtkmodules." + module)
        except ImportError:
            return None

    def parameter(self, text, place):
        name, named, rest = text.partition(":")
        if not named:  # in the header it has none
            name, rest = f"arg{place}", text
        kind, _, default = rest.partition("=")
        name = name.strip()
        # An object may be None; VTK's methods take no keywords.
        hint = self.type_of(kind, True)
        if hint in self.names or re.fullmatch(r"vtk\w+", hint):
            hint = f"Optional[{hint}]"
        return f"__{name.lstrip('_')}: {hint}" + (" = ..." if default else "")

    def method(self, name, signature, overloaded):
        arguments, result = SIGNATURE.match(signature).group(2, 3)
        parts = split(arguments)
        own = parts[:1] == ["self"]
        parameters = [self.parameter(part, place) for place, part in enumerate(parts[own:])]
        hint = self.type_of(result, False) if result else "None"
        lines = ["    @overload"] if overloaded else []
        lines += [] if own else ["    @staticmethod"]
        lines.append(f"    def {name}({', '.join(['self'] * own + parameters)}) -> {hint}: ...")
        return lines

    def class_(self, class_):
        base = class_.__mro__[1]
        if base.__name__ not in self.names:
            self.name(base.__name__)
        lines = [f"class {class_.__name__}({base.__name__}):"]
        doc = (class_.__doc__ or "").split("\n")[0].strip()
        if doc:
            lines.append(f'    """{doc}"""')
        for name, value in sorted(vars(class_).items()):
            if isinstance(value, int) and not isinstance(value, bool):
                lines.append(f"    {name}: int")
            elif isinstance(value, type):
                lines.append(f"    class {name}(int): ...")
            elif callable(value) and not name.startswith("__"):
                found = dict.fromkeys(signatures(value.__doc__))
                if found:
                    for signature in found:
                        lines += self.method(name, signature, len(found) > 1)
                else:
                    lines.append(f"    def {name}(self, *args: Any) -> Any: ...")
        return lines

    def text(self):
        classes = [line for class_ in self.in_order() for line in ["", "", *self.class_(class_)]]
        head = ["# Made by make_stubs.py from the module of the same name.",
                "from typing import Any, Optional, Sequence, Tuple, Union, overload", ""]
        head += [f"from {module} import {', '.join(sorted(names))}"
                 for module, names in sorted(self.imports.items())]
        return "\n".join(head + classes) + "\n"

    def in_order(self):
        """Bases first."""
        return sorted(self.classes, key=lambda class_: (len(class_.__mro__), class_.__name__))


def main():
    path, *rest = sys.argv[1:]
    modules = []
    for name, library in reversed(list(zip(rest[::2], rest[1::2]))):
        spec = importlib.util.spec_from_file_location(name, library)
        modules.append(importlib.util.module_from_spec(spec))
        sys.modules[name] = modules[-1]
        spec.loader.exec_module(modules[-1])
    text = Stubs(modules[-1], modules[:-1]).text()
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    main()
