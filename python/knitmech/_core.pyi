"""The compiled part of knitmech; the package has what is meant to be used.

n is the number of nodes, m that of elements. Every array is read-only.
"""

from collections.abc import Callable
from typing import Any, Optional

from numpy import float64, int32, ndarray, void
from numpy.typing import NDArray

from .errors import Mistake
from .parameters import Value

__version__: str

class Model:
    """Nodes, elements and node sets of a fabric."""

    @property
    def title(self) -> str: ...
    @property
    def nodes(self) -> NDArray[float64]:
        """(n, 3), stress-free positions [mm]"""
    @property
    def tangents(self) -> NDArray[float64]:
        """(n, 3), unit tangents of the yarns"""
    @property
    def arc_length(self) -> NDArray[float64]:
        """(n,), from the yarn's first node [mm]"""
    @property
    def course(self) -> NDArray[int32]:
        """(n,), counted from 0"""
    @property
    def wale(self) -> NDArray[int32]:
        """(n,), counted from 0; -1 on a turning arc"""
    @property
    def yarn_of_node(self) -> NDArray[int32]:
        """(n,)"""
    @property
    def elements(self) -> NDArray[int32]:
        """(m, 2), the two nodes of each element"""
    @property
    def yarn_of_element(self) -> NDArray[int32]:
        """(m,)"""
    @property
    def radius(self) -> NDArray[float64]:
        """(m,), of the yarn at each element [mm]"""
    @property
    def node_sets(self) -> dict[str, NDArray[int32]]:
        """By name; bottom_feet is held and top_heads is driven."""
    @property
    def tie_elements(self) -> NDArray[int32]:
        """(k, 2), the two elements that a tie joins, rows of elements"""
    @property
    def tie_shares(self) -> NDArray[float64]:
        """(k, 2), where on them: share of the way from their first node"""
    @property
    def gauge_length(self) -> float:
        """[mm], to which strains refer"""
    @property
    def friction(self) -> float:
        """[-]"""
    @property
    def contact_stiffness(self) -> float:
        """[N/mm], of one crossing"""

class Frame:
    """The fabric at one instant with its fields."""

    @property
    def index(self) -> int:
        """0, 1, 2, ... in the order of time"""
    @property
    def strain(self) -> float:
        """[-]"""
    @property
    def time(self) -> float:
        """[s]"""
    @property
    def row(self) -> void:
        """Its row of the history, columns by their names: frame.row["force_top_N"]."""
    @property
    def positions(self) -> NDArray[float64]:
        """(n, 3), of the nodes [mm]"""
    @property
    def rotations(self) -> NDArray[float64]:
        """(n, 4), of the nodes since the start: unit quaternions w, x, y, z"""
    @property
    def contact_force(self) -> NDArray[float64]:
        """(n, 3), on the nodes [N]"""
    @property
    def tie_force(self) -> NDArray[float64]:
        """(n, 3), by ties on the nodes [N]"""
    @property
    def gap(self) -> NDArray[float64]:
        """(n,), least distance to another piece of yarn [mm]; inf where none is near"""
    @property
    def axial_force(self) -> NDArray[float64]:
        """(m,) [N], pull positive"""
    @property
    def shear_force(self) -> NDArray[float64]:
        """(m,) [N], magnitude"""
    @property
    def bending_moment(self) -> NDArray[float64]:
        """(m,) [N mm], magnitude"""
    @property
    def torque(self) -> NDArray[float64]:
        """(m,) [N mm]"""
    @property
    def axial_strain(self) -> NDArray[float64]:
        """(m,) [-], stretch positive"""
    @property
    def curvature(self) -> NDArray[float64]:
        """(m,) [1/mm], magnitude of the change since the start"""
    @property
    def stretch_energy(self) -> NDArray[float64]:
        """(m,) [mJ]"""
    @property
    def bending_energy(self) -> NDArray[float64]:
        """(m,) [mJ]"""
    @property
    def twist_energy(self) -> NDArray[float64]:
        """(m,) [mJ]"""
    @property
    def broken(self) -> NDArray[int32]:
        """(k,), broken elements, rows of Model.elements"""
    @property
    def contacts(self) -> ndarray[Any, Any]:
        """A structured array, a row per contact with a force.

        first_yarn, first_course, first_place_mm, second_yarn, second_course, second_place_mm: what
            touches, as in Model.yarn_of_node and Model.course, and where along the yarns;
        position_mm (3), normal (3), gap_mm: the place, the direction from the first yarn to the
            second, and how far they are apart, negative where they press into each other;
        normal_force_N, friction_force_N (3): on the second yarn;
        slip_mm, elastic_slip_mm, slips: how far it has slid, and whether it slides now;
        crossing_angle_deg: between the yarns, 0 to 90.
        """

class StoredRun:
    @property
    def status(self) -> str: ...
    @property
    def reason(self) -> str: ...
    @property
    def advice(self) -> str: ...
    @property
    def summary(self) -> str: ...
    @property
    def history(self) -> ndarray[Any, Any]: ...
    @property
    def frames(self) -> list[tuple[int, float]]: ...
    @property
    def model(self) -> Model: ...
    def frame(self, index: int) -> Frame: ...
    def nearest_frame(self, strain: float) -> Frame: ...
    def write_report(self, threads: int) -> None: ...

def parameters() -> list[dict[str, Any]]: ...
def case_template() -> str: ...
def case_file_text(path: str) -> str: ...
def nearest_key(key: str) -> str: ...
def value_in(text: str, name: str, key: str) -> Value: ...
def given_keys(text: str, name: str) -> list[str]: ...
def with_value(text: str, name: str, key: str, typed: str) -> str: ...
def mistakes_in(text: str, name: str) -> list[Mistake]: ...
def check_json(text: str, name: str) -> str: ...
def model_of(text: str, name: str) -> Model: ...
def write_file(path: str, content: str) -> None: ...
def run_case(
    text: str,
    name: str,
    folder: str,
    on_frame: Optional[Callable[[Frame], Optional[bool]]],
    threads: Optional[int],
    pictures: bool,
) -> None: ...
def resume_run(
    folder: str,
    on_frame: Optional[Callable[[Frame], Optional[bool]]],
    threads: Optional[int],
    pictures: bool,
) -> None: ...
def read_run(folder: str) -> StoredRun: ...
def export_formats() -> list[tuple[str, str, bool]]: ...
def export_case(text: str, name: str, format: str, file: str, sides: int) -> list[str]: ...
def export_run(
    run: StoredRun, frame: Optional[Frame], format: str, file: str, sides: int
) -> list[str]: ...
