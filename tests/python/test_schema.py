# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""The schema of project files and the reader say the same: what must be there, what holds where a key is left out, and which range it has."""
import copy
import json
import math
import subprocess

import pytest

import hygroloom
from conftest import PROGRAM

SCHEMA = json.loads(subprocess.run([PROGRAM, "reference", "--as", "schema"], capture_output=True, check=True).stdout)
OTHER_NAME = {"sorption_heat_j_g": "heat_of_wetting_j_g"}  # of the same value, which messages call so
KEPT_AS_GIVEN = {("seams", "default"), ("gap_mm", "default")}  # a project that says them differs from one that does not; both mean the same
AIR = {"temperature_c": 21.0, "relative_humidity": 0.5, "air_speed_m_s": 0.2}


def whole_project():
    """Has each kind of object that a project may hold."""
    yarn = {"material": [{"name": "own", "share": 0.6}, {"name": "polyester", "share": 0.4}], "linear_density_tex": 20.0, "packing_factor": 0.6,
            "fibres_per_yarn": 30, "twist_per_m": 700.0, "plies": 2, "ply_twist_per_m": 500.0, "irregularity_cv": 0.1}  # fmt: skip
    fabric = {"name": "cloth", "warp": yarn, "weft": {**yarn, "core": {"material": "elastane", "share": 0.05}}, "weave": {"pattern": "plain"},
              "ends_per_cm": 20.0, "picks_per_cm": 20.0, "uncertainty": {"contact_angle_deg": 5.0},
              "flyaway": {"loop_density_per_mm": 6.0, "hair_density_per_mm": 10.0, "loop_height_mm": 0.1, "hair_length_mm": 0.4}}  # fmt: skip
    kinds = ("droplet", "moisture_management", "vertical_wicking", "horizontal_wicking", "drying", "conditioning", "sweat")
    experiments = [{"name": kind, "type": kind, "climate": dict(AIR), "duration_s": 10.0} for kind in kinds]
    experiments[0]["droplets"] = [{"volume_ul": 5.0, "time_s": 0.0, "at_mm": [0.0, 0.0], "height_mm": 2.0, "speed_m_s": 0.0}]
    experiments[4]["climate"] = [{"time_s": 0.0, **AIR}, {"time_s": 5.0, **AIR}]
    experiments[5]["initial"] = dict(AIR)
    wear = {"name": "wear", "type": "wear", "garment": "tee", "climate": dict(AIR), "duration_s": 60.0,
            "activity": [{"time_s": 0.0, "factor": 1.0}, {"time_s": 20.0, "factor": 0.2}]}  # fmt: skip
    garment = {"name": "tee", "source": {"built_in": "tee", "chest_mm": 1000.0, "length_mm": 700.0}, "panels": {"*": {"fabric": "cloth", "grain_deg": 0.0}},
               "seams": {"default": 1.0}, "wearer": {"skin_temperature_c": 34.0, "gap_mm": {"default": 3.0}}}  # fmt: skip
    return {"format": "hygroloom-project", "version": 1, "materials": [{"name": "own", "based_on": "cotton"}],
            "liquids": [{"name": "dye", "surface_tension_mn_m": 70.0, "viscosity_mpa_s": 1.2, "density_kg_m3": 1010.0}], "fabrics": [fabric], "experiments": [*experiments, wear], "garments": [garment]}  # fmt: skip


def fits(schema, value):
    """Whether a value may be meant by this branch."""
    schema = resolved(schema)
    if "const" in schema:
        return value == schema["const"]
    if "enum" in schema:
        return value in schema["enum"]
    kinds = {"object": dict, "array": list, "string": str, "number": (int, float), "integer": int, "boolean": bool}
    if not isinstance(value, kinds.get(schema.get("type"), object)):
        return False
    return not isinstance(value, dict) or all(fits(schema["properties"][key], value[key]) if key == "type" else key in schema["properties"] for key in value)


def resolved(schema):
    while "$ref" in schema:
        schema = {**SCHEMA["$defs"][schema["$ref"].rsplit("/", 1)[1]], **{key: of for key, of in schema.items() if key != "$ref"}}
    return schema


def objects(schema, value, path=()):
    """Each object of the document with its part of the schema."""
    schema = resolved(schema)
    for several in ("oneOf", "anyOf"):
        branches = [branch for branch in schema.get(several, []) if ("type" in resolved(branch) or "$ref" in branch) and fits(branch, value)]
        if branches:
            yield from objects(branches[0], value, path)
            return
    if isinstance(value, dict) and "properties" in schema:
        yield path, schema, value
        for key, of in value.items():
            if key in schema["properties"]:
                yield from objects(schema["properties"][key], of, (*path, key))
    elif isinstance(value, list) and "items" in schema:
        for number, of in enumerate(value):
            yield from objects(schema["items"], of, (*path, number))


def places():
    return list(objects(SCHEMA, whole_project()))


def put(document, path, key, value):
    """A copy with that value at that place; without the key where the value is None."""
    other = copy.deepcopy(document)
    holder = other
    for step in path:
        holder = holder[step]
    if value is None:
        holder.pop(key, None)
    else:
        holder[key] = value
    return other


def said_of(document, path, key):
    """What the reader or the check says against the value at that place."""
    where = ""
    for step in (*path, OTHER_NAME.get(key, key)):
        where += f"[{step}]" if isinstance(step, int) else ("." if where else "") + step
    try:
        project = hygroloom.Project.from_json(document)
    except hygroloom.FileError as error:
        return str(error) if key in str(error) else ""
    errors = [issue for issue in project.validate() if issue.severity == "error" and issue.where == where and issue.code == "range"]
    return errors[0].text if errors else ""


def is_of_another_type(document, path, key):
    """Of an experiment: the schema has the keys of all types in one list."""
    return path[:1] == ("experiments",) and f'The key "{key}" is not known here' in said_of(document, path, key)


def test_the_project_has_no_error_and_each_object():
    errors = [issue for issue in hygroloom.Project.from_json(whole_project()).validate() if issue.severity == "error"]
    assert not errors
    assert len(places()) >= 40


@pytest.mark.parametrize("path, schema, value", places(), ids=lambda of: ".".join(map(str, of)) if isinstance(of, tuple) else "")
def test_what_must_be_there_and_what_holds_without(path, schema, value):
    document, faults = whole_project(), []
    required = list(schema.get("required", []))
    if path[-2:-1] == ("climate",) and path[-1] > 0:
        required.append("time_s")  # of all but the first, as the schema says in words
    if "properties" in schema.get("if", {}) and schema["if"]["properties"]["type"]["const"] == value["type"]:
        required += schema["then"]["required"]
    for key, of in schema["properties"].items():
        of = resolved(of)
        without = put(document, path, key, None)
        if key in value:
            said = said_of(without, path, key)
            missing = f'The key "{key}" is missing' in said
            if (missing and key not in required) or (key in required and not said):
                faults.append(f"{key}: required in the schema: {key in required}; the reader says: {said or 'nothing'}")
        given = put(document, path, key, of["default"]) if "default" in of else document
        if "default" in of and key not in required and (path[-1], key) not in KEPT_AS_GIVEN and not is_of_another_type(given, path, key):
            try:
                bare, given = (hygroloom.Project.from_json(one) for one in (without, given))
            except hygroloom.FileError as error:
                faults.append(f"{key}: default {of['default']}: {error}")
                continue
            if bare != given:
                faults.append(f"{key}: the schema's default {of['default']} is not what holds without it")
    assert not faults, "\n".join(faults)


@pytest.mark.parametrize("path, schema, value", places(), ids=lambda of: ".".join(map(str, of)) if isinstance(of, tuple) else "")
def test_ranges_are_those_that_the_check_knows(path, schema, value):
    document, faults = whole_project(), []
    for key, of in schema["properties"].items():
        of = resolved(of)
        if of.get("type") not in ("number", "integer") or is_of_another_type(put(document, path, key, 1), path, key):
            continue
        step = 1 if of["type"] == "integer" else None
        # Some values do not go with those of other keys, which is said in other words.
        for bound, sign in (("minimum", -1), ("maximum", 1), ("exclusiveMinimum", -1)):
            if bound not in of:
                continue
            limit = of[bound]
            beyond = limit + sign * (step or max(1e-9, abs(limit) * 1e-6))
            inside = limit if not bound.startswith("exclusive") else math.nextafter(limit, math.inf)
            if not bound.startswith("exclusive") and " must be " in (said := said_of(put(document, path, key, inside), path, key)):
                faults.append(f"{key}: {inside} is within the schema's range; the reader: {said}")
            if not said_of(put(document, path, key, beyond), path, key):
                faults.append(f"{key}: {beyond} is beyond the schema's {bound}; the reader takes it")
    assert not faults, "\n".join(faults)
