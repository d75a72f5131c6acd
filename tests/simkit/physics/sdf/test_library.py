"""The library finds models, and nothing that it shall not find."""

from __future__ import annotations

import pytest

from simkit.errors import SimkitError
from simkit.packages import PackagePath
from simkit.physics.sdf import ModelLibrary, plan_model, read_model_text
from simkit.physics.sdf.library import BUILT_IN

MODEL = '<sdf version="{}"><model name="{}"><static>1</static><link name="link"/></model></sdf>'


@pytest.fixture
def package(tmp_path):
    """A package `shop` with the models `shelf`, in several versions, and `box`."""
    shop = tmp_path / "shop"
    shelf, box = shop / "models" / "shelf", shop / "models" / "box"
    for folder in (shelf, box):
        folder.mkdir(parents=True)
    (shop / "package.xml").write_text("<package/>")
    listed = "".join(f'<sdf version="{v}">shelf-{v}.sdf</sdf>' for v in ("1.4", "1.6", "1.9"))
    (shelf / "model.config").write_text(f"<model>{listed}</model>")
    for version in ("1.4", "1.6", "1.9"):
        (shelf / f"shelf-{version}.sdf").write_text(MODEL.format(version, version))
    (box / "model.sdf").write_text(MODEL.format("1.5", "box"))
    return tmp_path


def test_the_newest_version_that_is_read_is_taken(package):
    library = ModelLibrary(packages=PackagePath([package]))
    text, file = library.read("model://shelf")
    assert b'name="1.6"' in text
    assert file.endswith("shelf-1.6.sdf")


def test_a_model_without_config_is_its_sdf(package):
    text, _ = ModelLibrary(packages=PackagePath([package])).read("model://box")
    assert b'name="box"' in text


def test_a_folder_of_models_may_be_given(package):
    library = ModelLibrary([package / "shop" / "models"])
    assert library.names() == ["box", "ground_plane", "shelf", "sun"]
    assert library.read("model://box")[0]


def test_a_folder_may_be_named(package):
    folder = package / "shop" / "models" / "box"
    assert ModelLibrary().read(f"file://{folder}")[0]


@pytest.mark.parametrize(
    "uri", ["model://", "model://../etc", "model://a/b", "box", "http://x/box"]
)
def test_what_names_no_model_is_refused(package, uri):
    with pytest.raises(SimkitError, match="names no model"):
        ModelLibrary(packages=PackagePath([package])).read(uri)


def test_an_unknown_model_lists_those_that_there_are(package):
    with pytest.raises(SimkitError, match="did you mean 'shelf'"):
        ModelLibrary(packages=PackagePath([package])).read("model://shelv")


def test_a_confined_library_stays_in_its_packages(package, tmp_path):
    outside = tmp_path / "outside" / "secret"
    outside.mkdir(parents=True)
    (outside / "model.sdf").write_text(MODEL.format("1.6", "secret"))
    (package / "shop" / "models" / "link").symlink_to(outside)
    (package / "shop" / "models" / "box" / "model.config").write_text(
        '<model><sdf version="1.6">../../../outside/secret/model.sdf</sdf></model>'
    )
    library = ModelLibrary(packages=PackagePath([package], confined=True))
    for uri in (f"file://{outside}", "model://link", "model://box"):
        with pytest.raises(SimkitError, match="outside of the package folders"):
            library.read(uri)
    path, problem = library.mesh("model://link/model.sdf")
    assert path is None
    assert "outside of the package folders" in problem


def test_meshes_are_found_in_models(package):
    (package / "shop" / "models" / "box" / "a.stl").write_bytes(b"")
    library = ModelLibrary(packages=PackagePath([package]))
    assert library.mesh("model://box/a.stl")[0].name == "a.stl"
    assert library.mesh("model://box/b.stl")[0] is None
    assert library.mesh("a.stl") == (None, "only names that begin with model:// are looked for")


def test_a_missing_file_is_said(package):
    (package / "shop" / "models" / "shelf" / "shelf-1.6.sdf").unlink()
    with pytest.raises(SimkitError, match="there is no"):
        ModelLibrary(packages=PackagePath([package])).read("model://shelf")


@pytest.mark.parametrize("name", sorted(set(BUILT_IN) - {"sun"}))
def test_what_is_built_in_can_be_simulated(name):
    model, diagnostics = read_model_text(BUILT_IN[name], file=name)
    assert not diagnostics
    assert plan_model(model).is_static
