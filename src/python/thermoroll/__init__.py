# Tangled from paper/K-from-other-languages.md; edit there.
"""Rolling contact of a cylinder with frictional heating, by the shared library of thermoroll.

All numbers are dimensionless, as in the report. Arguments are broadcast against each other as
NumPy does, and results have the broadcast shape. The library is looked for in the file
THERMOROLL_LIBRARY, beside an installed module, below sys.prefix, and where the system looks.
"""

from __future__ import annotations

import ctypes
import dataclasses
import math
import operator
import os
import sys
import time
import weakref
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Law", "LawValues", "Solution", "Values", "law", "solve", "version"]

def _structure(*members: str) -> np.dtype:
    return np.dtype([tuple(member.split()) for line in members for member in line.split(",")])


_scene = _structure(
    "size u4, quantity i4, given f8, friction f8, peclet f8, heating f8, roller i4, direction i4",
    "conductivity_ratio f8, heating_2 f8, peclet_2 f8, bulk_difference f8, friction_law i4",
    "branch i4, friction_temperature f8, friction_floor f8, friction_reference_temperature f8",
    "method i4, formulation i4, tolerance f8, nodes i4, unused i4",
)

_values = _structure(
    "stick_slip_border f8, slip_length f8, traction f8, creep_constant f8, creep f8",
    "load_ratio f8, gamma0 f8, heat_integral f8, max_temperature f8, max_temperature_at f8",
    "eccentricity f8, heat_1 f8, heat_2 f8, traction_limit f8, creep_at_traction_limit f8",
)
_result = np.dtype(
    _structure("size u4, status i4, model i4, unknowns i4").descr
    + [("value", _values), ("error", _values), ("message", "S256")]
)
_law_info = _structure("size u4, status i4, driving_end f8, braking_end f8, message S256")
_law_value = _structure(
    "size u4, status i4, traction f8, slope f8, max_temperature f8, stick_slip_border f8",
    "traction_error f8, max_temperature_error f8, stick_slip_border_error f8",
)

def _load() -> ctypes.CDLL:
    name = "libthermoroll_c.so.0"
    asked = os.environ.get("THERMOROLL_LIBRARY")
    beside = [str(folder / name) for folder in list(Path(__file__).resolve().parents)[3:4]]
    reasons = []
    for place in [asked] if asked else [*beside, f"{sys.prefix}/lib/{name}", name]:
        try:
            return ctypes.CDLL(place)
        except OSError as error:
            reasons.append(str(error))
    raise ImportError(
        f"thermoroll lacks its library: run make install, or set THERMOROLL_LIBRARY ({'; '.join(reasons)})"
    )

_library = _load()


def _function(name: str, result: type | None, *arguments: type):
    try:
        function = getattr(_library, "thermoroll_" + name)
    except AttributeError:
        raise ImportError(f"{_library._name} has no thermoroll_{name}: it is of another version") from None
    function.restype, function.argtypes = result, arguments
    return function


_array, _count = ctypes.c_void_p, ctypes.c_size_t
_version = _function("version", ctypes.c_char_p)
_solve = _function("solve", ctypes.c_int, _array, _array, _count, ctypes.c_int)
_law_new = _function("law_new", ctypes.c_void_p, _array, ctypes.c_double, _array)
_law_evaluate = _function("law_evaluate", ctypes.c_int, _array, _array, _array, _count)
_law_free = _function("law_free", None, ctypes.c_void_p)


def version() -> str:
    """The version of the library, as "0.2.0"."""
    return _version().decode()

_models = ("closed-form", "first-order", "coupled")
_words = {
    "quantity": ("traction", "creep", "stick_slip_border"),
    "roller": ("insulated", "identical", "conducting"),
    "direction": ("driving", "braking"),
    "friction_law": ("constant", "linear", "exponential", "rational", "piecewise-linear"),
    "branch": ("rising", "falling"),
    "method": ("auto", *_models, "gauss-chebyshev"),
    "formulation": ("printed", "corrected"),
}

def _numbers(name: str, value: ArrayLike) -> NDArray:
    if np.ma.is_masked(value):
        raise TypeError(f"{name} has masked values: fill them, or leave their scenes out")
    given = np.asarray(value)
    if name in _words:
        numbers = np.full(given.shape, -1)
        for number, word in enumerate(_words[name]):
            numbers[given == word] = number
        if (numbers < 0).any():
            raise ValueError(f"{name} must be one of {', '.join(_words[name])}")
        return numbers
    if name == "nodes" and not np.issubdtype(given.dtype, np.integer):
        raise TypeError("nodes must be whole numbers")
    return given.astype(float)

def _scenes(members: dict[str, ArrayLike | None]) -> NDArray:
    given = [name for name in _words["quantity"] if members.get(name) is not None]
    if len(given) != 1:
        raise TypeError("exactly one of traction, creep and stick_slip_border is needed")
    rest = {name: x for name, x in members.items() if name not in _words["quantity"]}
    rest.update(quantity=given[0], given=members[given[0]], unused=0)
    numbers = {name: _numbers(name, x) for name, x in rest.items()}
    try:
        shape = np.broadcast_shapes(*(x.shape for x in numbers.values()))
    except ValueError:
        arrays = ", ".join(f"{name} {x.shape}" for name, x in numbers.items() if x.shape)
        raise ValueError(f"these shapes do not fit: {arrays}") from None
    scenes = np.empty(shape, _scene)
    scenes["size"] = _scene.itemsize
    for name, x in numbers.items():
        scenes[name] = x
    return scenes

@dataclasses.dataclass(frozen=True, eq=False)
class Values:
    """Results of scenes, or their estimated absolute errors: arrays of one shape, dimensionless."""

    stick_slip_border: NDArray  #: c0, -1 in full slip
    slip_length: NDArray  #: 1 - c0, to its own digits
    traction: NDArray  #: Q*, negative when braking
    creep_constant: NDArray  #: C
    creep: NDArray  #: xi*, negative when braking
    load_ratio: NDArray  #: kappa
    gamma0: NDArray  #: gamma0
    heat_integral: NDArray  #: the integral of v* p*
    max_temperature: NDArray  #: the largest T* on the surface
    max_temperature_at: NDArray  #: s there
    eccentricity: NDArray  #: of the contact's centre from the axis
    heat_1: NDArray  #: the heat that flows into the half-space
    heat_2: NDArray  #: the heat that flows into the roller
    traction_limit: NDArray  #: the largest traction, of a given traction with a law, or NaN
    creep_at_traction_limit: NDArray  #: the creep there

@dataclasses.dataclass(frozen=True, eq=False)
class Solution(Values):
    """Solved scenes. Where the status is not 0, the results are NaN and the message says why."""

    errors: Values  #: estimated absolute errors; NaN for the published scheme
    status: NDArray  #: 0 done, 1 failed, 2 refused, 3 not converged, 5 no contact
    model: NDArray  #: "closed-form", "first-order" or "coupled"; "" for none
    unknowns: NDArray  #: of the last grid, 0 without one
    _messages: NDArray = dataclasses.field(repr=False)

    @property
    def messages(self) -> NDArray | str:
        """Why each scene failed, or why its model was enough."""
        return np.frompyfunc(bytes.decode, 1, 1)(self._messages)

def _columns(rows: NDArray) -> dict[str, NDArray]:
    return {name: rows[name].copy()[()] for name in rows.dtype.names}


def _solution(rows: NDArray) -> Solution:
    return Solution(
        **_columns(rows["value"]),
        errors=Values(**_columns(rows["error"])),
        status=rows["status"].copy()[()],
        model=np.array([*_models, ""])[rows["model"]],
        unknowns=rows["unknowns"].copy()[()],
        _messages=rows["message"].copy()[()],
    )

_block_time, _largest_block = 0.2, 8192


def _next_block(size: int, seconds: float) -> int:
    return max(16, min(int(size * _block_time / max(seconds, 1e-4)), 4 * size, _largest_block))

def _solve_all(scenes: NDArray, threads: int) -> NDArray:
    results = np.zeros(scenes.shape, _result)
    results["size"] = _result.itemsize
    rows, answers = scenes.reshape(-1), results.reshape(-1)
    begin, size = 0, 256
    while begin < rows.size:
        part, told = rows[begin : begin + size], answers[begin : begin + size]
        start = time.monotonic()
        if _solve(part.ctypes.data, told.ctypes.data, part.size, threads) == 2:
            raise RuntimeError("the library has other structures: it is of another version")
        begin, size = begin + size, _next_block(size, time.monotonic() - start)
    return results

def solve(
    *,
    friction: ArrayLike,
    peclet: ArrayLike,
    heating: ArrayLike = 0.0,
    traction: ArrayLike | None = None,
    creep: ArrayLike | None = None,
    stick_slip_border: ArrayLike | None = None,
    roller: ArrayLike = "insulated",
    conductivity_ratio: ArrayLike = 0.0,
    heating_2: ArrayLike = 0.0,
    peclet_2: ArrayLike = 0.0,
    bulk_difference: ArrayLike = 0.0,
    friction_law: ArrayLike = "constant",
    friction_temperature: ArrayLike = 0.0,
    friction_floor: ArrayLike = 0.0,
    friction_reference_temperature: ArrayLike = 0.0,
    formulation: ArrayLike = "corrected",
    direction: ArrayLike = "driving",
    branch: ArrayLike = "rising",
    method: ArrayLike = "auto",
    tolerance: ArrayLike = 1e-6,
    nodes: ArrayLike = 200,
    threads: int = 0,
) -> Solution:
    """
    Solve scenes on all processors; each argument is a number, a word, or an array of them.

    friction: f > 0. peclet: Pe > 0. heating: H >= 0.
    traction, creep or stick_slip_border: exactly one. Q* from -f to f or xi*, negative for
        braking; or c0 between -1 and 1.
    roller: "insulated", "identical" or "conducting".
    conductivity_ratio, heating_2, peclet_2: K2 / K1 > 0, H2 >= 0 and Pe2 > 0 (0: Pe), for a
        conducting roller only. bulk_difference: Theta, by how much it is warmer far away.
    friction_law: "constant", "linear", "exponential", "rational" or "piecewise-linear", with
        friction_temperature (T0*), friction_floor (0 to 1), friction_reference_temperature.
    formulation: "corrected" or "printed".
    direction: "driving" or "braking", of a border. branch: "rising" or "falling", of a traction
        with a law of friction.
    method: "auto", "closed-form", "first-order", "coupled" or "gauss-chebyshev". The closed form
        asked for by name leaves out what the heat does to the tractions, in its errors too.
    tolerance: 1e-11 to 1e-2. nodes: of gauss-chebyshev, 3 to 5000.
    threads: how many, 0 for one on each processor; the results are the same.

    Returns the results in the broadcast shape of all arguments. A scene that fails raises nothing:
    it has a status, a message and NaN. Raises ValueError for an unknown word or shapes that do not
    fit, and TypeError unless exactly one quantity is given.
    """
    members = {name: x for name, x in locals().items() if name != "threads"}
    if not 0 <= operator.index(threads) <= 1024:
        raise ValueError("threads must be from 0, for all processors, to 1024")
    return _solution(_solve_all(_scenes(members), threads))

@dataclasses.dataclass(frozen=True, eq=False)
class LawValues:
    """A law at creeps: arrays of their shape, dimensionless; NaN beyond the end of the law."""

    traction: NDArray  #: Q*, with the sign of the creep
    slope: NDArray  #: dQ*/dxi*; it has no error estimate
    max_temperature: NDArray  #: the largest T*
    stick_slip_border: NDArray  #: c0, -1 in full slip
    traction_error: NDArray  #: estimated, absolute, as are the next two
    max_temperature_error: NDArray
    stick_slip_border_error: NDArray
    status: NDArray  #: 0, or 2 beyond the end of the law

class Law:
    """Traction, temperature and border of a scene by creep; made by law()."""

    driving_end: float  #: the size of the creep where it ends, infinite if it does not
    braking_end: float
    message: str  #: why it ends; "" if it does not

    def __init__(self, handle: int, info: NDArray) -> None:
        self._handle = handle
        self._free = weakref.finalize(self, _law_free, handle)
        self.driving_end = float(info["driving_end"])
        self.braking_end = float(info["braking_end"])
        self.message = info["message"][()].decode()

    def __reduce__(self):
        raise TypeError("a law cannot be copied or pickled: make it again by law()")

    def __call__(self, creep: ArrayLike) -> LawValues:
        """The law at creeps xi* of either sign."""
        creeps = np.array(_numbers("creep", creep), order="C")
        values = np.zeros(creeps.shape, _law_value)
        values["size"] = _law_value.itemsize
        _law_evaluate(self._handle, creeps.ctypes.data, values.ctypes.data, creeps.size)
        columns = _columns(values)
        del columns["size"]
        return LawValues(**columns)

def law(
    *,
    friction: ArrayLike,
    peclet: ArrayLike,
    heating: ArrayLike = 0.0,
    roller: ArrayLike = "insulated",
    conductivity_ratio: ArrayLike = 0.0,
    heating_2: ArrayLike = 0.0,
    peclet_2: ArrayLike = 0.0,
    bulk_difference: ArrayLike = 0.0,
    friction_law: ArrayLike = "constant",
    friction_temperature: ArrayLike = 0.0,
    friction_floor: ArrayLike = 0.0,
    friction_reference_temperature: ArrayLike = 0.0,
    formulation: ArrayLike = "corrected",
    tolerance: ArrayLike = 1e-4,
    reach: float = math.inf,
) -> Law:
    """The law of all creeps of one scene, driving and braking, with the arguments of solve().

    tolerance: of traction, border and relative temperature, 1e-7 to 1e-2. reach: the size of the
    creep up to which full slip is computed. Raises ValueError for data out of range, RuntimeError
    if there is no law to this tolerance.
    """
    members = {name: x for name, x in locals().items() if name != "reach"}
    rest = {"direction": "driving", "branch": "rising", "method": "auto", "nodes": 200}
    scene = _scenes({**members, **rest, "traction": 0.0})
    if scene.shape:
        raise ValueError("a law is of one scene: its arguments are single numbers")
    info = np.zeros((), _law_info)
    info["size"] = _law_info.itemsize
    handle = _law_new(scene.ctypes.data, reach, info.ctypes.data)
    if not handle:
        raised = ValueError if info["status"] == 2 else RuntimeError
        raise raised(info["message"][()].decode())
    return Law(handle, info)
