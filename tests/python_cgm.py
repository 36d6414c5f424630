"""Counts the elements that python-cgm finds in a metafile: a line with class, number and count for each kind."""

import collections
import importlib.util
import pathlib
import sys
import types

# Its parser without the parts that draw, which need more packages.
package = types.ModuleType("cgm")
package.__path__ = [str(pathlib.Path(importlib.util.find_spec("cgm").origin).parent)]
sys.modules["cgm"] = package

from cgm.parser import iter_elements  # noqa: E402

found = collections.Counter()
for element in iter_elements(pathlib.Path(sys.argv[1]).read_bytes()):
    found[element.class_id, element.element_id] += 1
for (class_id, element_id), count in sorted(found.items()):
    print(class_id, element_id, count)
