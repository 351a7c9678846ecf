# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Projects: what is read, changed and saved, and what is refused."""
import json
import pathlib
import pickle

import numpy as np
import pytest

import hygroloom


def test_values_are_those_of_the_file(examples):
    project = hygroloom.Project.open(examples / "laboratory.hygro")
    file = json.loads((examples / "laboratory.hygro").read_text())
    assert project.fabrics == [fabric["name"] for fabric in file["fabrics"]]
    assert project.experiment_types == {of["name"]: of["type"] for of in file["experiments"]}
    assert project.get("fabrics.Textile F.ends_per_cm") == file["fabrics"][0]["ends_per_cm"]
    assert project.get("experiments[0].droplets[0]")["volume_ul"] == 15
    assert project.get("experiments.one drop.sample_mm") == [20, 20]
    assert project.to_dict()["fabrics"] == project.get("fabrics")


def test_a_changed_project_is_saved_and_read_again(examples, tmp_path):
    project = hygroloom.Project.open(examples / "laboratory.hygro")
    before = project.copy()
    project.set("fabrics[0].contact_angle_deg", np.float64(60)).set("fabrics[0].name", "12").set("fabrics[0].weave.pattern", "twill 2/2 Z")
    project.set("experiments[0].sample_mm", np.array([10.0, 12.0]))
    assert project != before and before.fabrics == ["Textile F"]
    assert project.save(tmp_path / "ä b.hygro") == tmp_path / "ä b.hygro"
    again = hygroloom.Project.open(str(tmp_path / "ä b.hygro"))
    assert again == project and again.fabrics == ["12"]
    assert again.get("fabrics[0].contact_angle_deg") == 60 and again.get("experiments[0].sample_mm") == [10, 12]
    again.set("fabrics[0].contact_angle_deg", None)
    assert again.get("fabrics[0].contact_angle_deg", "own") == "own"
    again.save()
    assert (tmp_path / "ä b.hygro~").read_text() == project.to_json()


def test_issues_say_where(examples):
    project = hygroloom.Project.open(examples / "laboratory.hygro")
    assert not [issue for issue in project.validate() if issue.severity == "error"]
    project.set("fabrics[0].ends_per_cm", -3)
    errors = [issue for issue in project.validate() if issue.severity == "error"]
    assert errors[0].where == "fabrics[0].ends_per_cm" and "-3" in errors[0].text
    with pytest.raises(hygroloom.InvalidProject, match="fabrics.0..ends_per_cm: .*-3") as refused:
        hygroloom.simulate(project, experiment="one drop")
    assert errors[0] in refused.value.issues and isinstance(refused.value, (hygroloom.Error, ValueError))


@pytest.mark.parametrize(
    "path, value, words",
    [
        ("fabrics[0].contct_angle_deg", 3, "contct_angle_deg"),
        ("fabrics[9].ends_per_cm", 3, "There is no fabrics.9."),
        ("fabrics[0].ends_per_cm", "many", "must be a number in /cm; given is .many."),
        ("fabrics[0].ends_per_cm", {"a": 1}, "ends_per_cm"),
        ("fabrics[0].contact_angle_deg", "60", "must be a number in °; given is .60.\\.$"),
        ("fabrics[0].thickness_mm", "0.3 deg", "must be a number in mm; given is"),
        ("experiments[0].sample_mm", ["20", 20], "must be a number"),
        ("fabrics[-2].ends_per_cm", 3, "There is no fabrics.-2.; this project has 1 .fabrics.0..\\.$"),
        ("fabrics[9999999999999999999999].ends_per_cm", 3, "Textile F"),
        ("", 3, "path is empty"),
        ("fabrics[", 3, "missing"),
    ],
)
def test_wrong_changes_leave_the_project_as_it_was(examples, path, value, words):
    project = hygroloom.Project.open(examples / "laboratory.hygro")
    before = project.to_json()
    with pytest.raises(hygroloom.Error, match=words) as refused:
        project.set(path, value)
    assert "--set" not in str(refused.value) and (not path or str(refused.value).count(path) <= 1)
    assert project.to_json() == before


def test_places_count_from_the_end_too(examples):
    project = hygroloom.Project.open(examples / "laboratory.hygro")
    last = len(project.experiments) - 1
    assert project.get("experiments[-1].name") == project.get(f"experiments[{last}].name")
    project.set("experiments[-1].name", "last").set("experiments[0].droplets[-1].volume_ul", 7)
    assert project.experiments[-1] == "last" and project.get("experiments[0].droplets[0].volume_ul") == 7


@pytest.mark.parametrize("odd", ["a\ud800b", ["a\udfff"], {"a\ud800": 1}, {"name": "\ud83d"}, "\udce4.hygro"])
def test_halves_of_letters_are_refused(examples, odd):
    project = hygroloom.Project.open(examples / "laboratory.hygro")
    before = project.to_json()
    for use in (lambda: project.set("fabrics[0].name", odd), lambda: hygroloom.Project.from_json({"fabrics": odd})):
        with pytest.raises(ValueError, match=": This must be Unicode text; given is"):
            use()
    assert project.to_json() == before
    names = ["ä😀\U0010ffff", '"quoted"', "true", "null", "[1]", "1e400", "60 deg", "a\nb"]
    for name in names:
        assert project.set("fabrics[0].name", name).fabrics == [name]


def test_wrong_arguments_are_named(examples, tmp_path):
    project = hygroloom.Project.open(examples / "laboratory.hygro")
    for wrong, error in ((float("nan"), ValueError), (object(), TypeError), ({1, 2}, TypeError)):
        with pytest.raises(error, match="fabrics.0..ends_per_cm: This must be a"):
            project.set("fabrics[0].ends_per_cm", wrong)
    within = []
    within.append(within)
    with pytest.raises(ValueError, match="must not hold itself"):
        project.set("fabrics[0].ends_per_cm", within)
    for wrong in ({"knobs": {"fibre_shells": 10**400}}, {"cell_mm": 10**400}, {"fidelity": np.array(["draft", "live"])}):
        with pytest.raises(ValueError, match=f"{next(iter(wrong))}.*: This must be"):
            hygroloom.simulate(project, "a", "b", **wrong)
    with pytest.raises(TypeError, match="path: This must be a text; given is 3"):
        project.set(3, 3)
    with pytest.raises(hygroloom.Error, match="There is no .fabrcs. here"):
        project.get("fabrcs[0].name")
    with pytest.raises(hygroloom.Error, match="not set"):
        project.get("fabrics[0].porosity")
    with pytest.raises(TypeError, match="path: This must be a path; given is 3"):
        hygroloom.Project.open(3)
    with pytest.raises(ValueError, match="path: This must be a path"):
        hygroloom.Project.open("a\0b")
    with pytest.raises(ValueError, match="path: This must be Unicode text"):
        project.set("\ud800", 1)
    with pytest.raises(TypeError, match="Project.open"):
        hygroloom.Project("laboratory.hygro")
    with pytest.raises(hygroloom.FileError, match="none.hygro") as refused:
        hygroloom.Project.open(tmp_path / "none.hygro")
    assert isinstance(refused.value, OSError)
    with pytest.raises(hygroloom.FileError):
        hygroloom.Project.open(tmp_path)
    with pytest.raises(hygroloom.FileError, match="line 1"):
        hygroloom.Project.from_json("{ nothing")
    with pytest.raises(hygroloom.Error, match="no file yet"):
        hygroloom.Project.from_json(project.to_dict()).save()
    with pytest.raises(hygroloom.FileError):
        project.save(tmp_path / "no folder" / "a.hygro")
    assert project.path == examples / "laboratory.hygro"


def test_exceptions_can_be_pickled():
    error = pickle.loads(pickle.dumps(hygroloom.InvalidProject("Wrong.", [("error", "range", "fabrics[0]", "Too many.")])))
    assert str(error) == "Wrong." and error.issues[0].code == "range"
