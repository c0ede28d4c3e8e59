"""The structures and functions of libdomino, generated from its headers by header.py."""

from ctypes import (CFUNCTYPE, POINTER, Structure, c_bool, c_char_p, c_double, c_int, c_size_t, c_uint,
                    c_ulong, c_void_p)
from enum import IntEnum

SONAME = "libdomino.so.2"


class dom_status(IntEnum):
    DOM_OK = 0
    DOM_BAD_S = 1
    DOM_BAD_R = 2
    DOM_BAD_D = 3
    DOM_BAD_Q = 4
    DOM_BAD_WIDTH = 5
    DOM_BAD_MU = 6
    DOM_BAD_ALPHA = 7
    DOM_BAD_WALLS = 8
    DOM_BAD_RHO = 9
    DOM_BAD_AIR = 10
    DOM_BAD_DRAG = 11
    DOM_BAD_FUEL = 12
    DOM_BAD_TOL = 13
    DOM_BAD_METHOD = 14
    DOM_BAD_TILT = 15
    DOM_BAD_TIME = 16
    DOM_BAD_G = 17
    DOM_BAD_PUSH = 18
    DOM_BAD_RELEASE = 19
    DOM_BAD_COUNT = 20
    DOM_BAD_HEIGHT = 21
    DOM_BAD_THICKNESS = 22
    DOM_BAD_GAP = 23
    DOM_BAD_MASS = 24
    DOM_BAD_RADIUS = 25
    DOM_BAD_LEAN = 26
    DOM_BAD_ERROR = 27
    DOM_BAD_ROWS = 28
    DOM_BAD_PROBABILITY = 29
    DOM_BAD_SAFETY = 30
    DOM_BAD_HALL = 31
    DOM_OUT_OF_REACH = 32
    DOM_NO_FUEL = 33
    DOM_STOPS = 34
    DOM_LOCKS = 35
    DOM_NO_STAND = 36
    DOM_NO_ROOM = 37
    DOM_NO_ROUND = 38
    DOM_NO_LEAN = 39
    DOM_NO_AIR = 40
    DOM_NO_MARGIN = 41
    DOM_NO_GROWTH = 42
    DOM_OPEN = 43
    DOM_TOO_LONG = 44
    DOM_UNDERFLOW = 45
    DOM_NO_PRECISION = 46
    DOM_NO_METHOD = 47
    DOM_NOT_FINITE = 48
    DOM_NOT_CONVERGED = 49
    DOM_NO_MEMORY = 50
    DOM_INTERRUPTED = 51


class dom_fuel(IntEnum):
    DOM_FUEL_EXACT = 0
    DOM_FUEL_PAPER = 1


class dom_method(IntEnum):
    DOM_METHOD_OURS = 0
    DOM_METHOD_GSL = 1
    DOM_METHOD_PAPER = 2


class dom_effect_name(IntEnum):
    DOM_EFFECT_friction = 0
    DOM_EFFECT_slope = 1
    DOM_EFFECT_walls = 2
    DOM_EFFECT_edges = 3
    DOM_EFFECT_air = 4
    DOM_EFFECT_drag = 5
    DOM_EFFECT_row = 6
    DOM_EFFECT_push = 7
    DOM_EFFECT_release = 8
    DOM_EFFECT_placement = 9
    DOM_EFFECT_floor = 10
    DOM_EFFECT_COUNT = 11

DOM_DYNAMICS_COUNT = 6
DOM_EFFECT_ARGUMENTS = 3

class dom_end(IntEnum):
    DOM_END_NONE = 0
    DOM_END_BARRIER = 1
    DOM_END_REACH = 2


class dom_event_kind(IntEnum):
    DOM_EVENT_LAUNCH = 0
    DOM_EVENT_DETACH = 1
    DOM_EVENT_TOP = 2
    DOM_EVENT_STOP = 3
    DOM_EVENT_HIT = 4

DOM_EVENTS_MAX = 5

class dom_spacing(IntEnum):
    DOM_BY_TIME = 0
    DOM_BY_TILT = 1


class dom_question(IntEnum):
    DOM_ASK_ANGLES = 0
    DOM_ASK_CONTACT = 1
    DOM_ASK_ENERGY = 2
    DOM_ASK_FUEL = 3
    DOM_ASK_LAUNCH = 4
    DOM_ASK_BARRIER = 5
    DOM_ASK_OMEGASQ = 6
    DOM_ASK_DURATION = 7
    DOM_ASK_RMAX = 8
    DOM_ASK_PAIR = 9
    DOM_ASK_BEST = 10


class dom_row_end(IntEnum):
    DOM_ROW_FALLS = 0
    DOM_ROW_STOPS = 1
    DOM_ROW_MISSES = 2
    DOM_ROW_PASSES = 3
    DOM_ROW_LEANS = 4
    DOM_ROW_PARTS = 5
    DOM_ROW_LOCKS = 6
    DOM_ROW_SKEWED = 7
    DOM_ROW_BACK = 8

DOM_MENDS = 31

class dom_window_of(IntEnum):
    DOM_WINDOW_GAP = 0
    DOM_WINDOW_PLACE = 1
    DOM_WINDOW_HEIGHT = 2
    DOM_WINDOW_FRICTION = 3
    DOM_WINDOW_LEAN = 4
    DOM_WINDOW_THICKNESS = 5


class dom_least(IntEnum):
    DOM_LEAST_DOMINOES = 0
    DOM_LEAST_LENGTH = 1
    DOM_LEAST_MASS = 2


class dom_design_limit(IntEnum):
    DOM_DESIGN_FITS = 0
    DOM_DESIGN_SAFETY = 1
    DOM_DESIGN_START = 2
    DOM_DESIGN_HALL = 3
    DOM_DESIGN_ENGINE = 4
    DOM_DESIGN_FAILED = 5


class dom_error_of(IntEnum):
    DOM_ERROR_gap = 0
    DOM_ERROR_place = 1
    DOM_ERROR_height = 2
    DOM_ERROR_thickness = 3
    DOM_ERROR_mass = 4
    DOM_ERROR_lean = 5
    DOM_ERROR_radius = 6
    DOM_ERROR_friction = 7
    DOM_ERROR_slope = 8
    DOM_ERROR_floor = 9
    DOM_ERROR_push = 10
    DOM_ERROR_COUNT = 11


class dom_proof_gap(IntEnum):
    DOM_PROOF_NONE = 0
    DOM_PROOF_EFFECT = 1
    DOM_PROOF_ROUNDING = 2
    DOM_PROOF_BOXES = 3
    DOM_PROOF_INTERRUPTED = 4
    DOM_PROOF_MODE = 5


class dom_proof_end(IntEnum):
    DOM_PROVED_BARRIER = 0
    DOM_PROVED_REACH = 1
    DOM_PROVED_NONE = 2
    DOM_PROVED_PARTLY = 3


class dom_proof_verdict(IntEnum):
    DOM_PROVED_GOES_ON = 0
    DOM_PROVED_STOPS = 1
    DOM_PROVED_NO_FUEL = 2
    DOM_PROVED_OUT_OF_REACH = 3
    DOM_PROVED_NOTHING = 4


class dom_work(Structure):
    pass


class dom_train(Structure):
    pass


class dom_scale(Structure):
    pass


class dom_compute(Structure):
    pass


class dom_arithmetic(Structure):
    pass


class dom_angles(Structure):
    pass


class dom_contact(Structure):
    pass


class dom_link(Structure):
    pass


class dom_energy(Structure):
    pass


class dom_fuels(Structure):
    pass


class dom_launch(Structure):
    pass


class dom_barrier(Structure):
    pass


class dom_event(Structure):
    pass


class dom_state(Structure):
    pass


class dom_force(Structure):
    pass


class dom_least_force(Structure):
    pass


class dom_floor(Structure):
    pass


class dom_limit(Structure):
    pass


class dom_best(Structure):
    pass


class dom_effect_argument(Structure):
    pass


class dom_effect(Structure):
    pass


class dom_box(Structure):
    pass


class dom_count(Structure):
    pass


class dom_domino(Structure):
    pass


class dom_row(Structure):
    pass


class dom_fall(Structure):
    pass


class dom_verdict(Structure):
    pass


class dom_moment(Structure):
    pass


class dom_engine(Structure):
    pass


class dom_row_growth(Structure):
    pass


class dom_mend(Structure):
    pass


class dom_window(Structure):
    pass


class dom_limits(Structure):
    pass


class dom_wish(Structure):
    pass


class dom_design(Structure):
    pass


class dom_random_error(Structure):
    pass


class dom_placement(Structure):
    pass


class dom_study(Structure):
    pass


class dom_budget(Structure):
    pass


class dom_proof_work(Structure):
    pass


class dom_proof(Structure):
    pass


class dom_interval(Structure):
    pass


class dom_proof_cycle(Structure):
    pass


dom_work._fields_ = [
    ("passes", c_size_t),
    ("dominoes", c_size_t),
    ("longest", c_size_t),
    ("entered", c_size_t * 11),
]
dom_train._fields_ = [
    ("s", c_double),
    ("r", c_double),
    ("d", c_double),
    ("q", c_double),
    ("width", c_double),
    ("fuel", c_int),
    ("mu", c_double),
    ("alpha", c_double),
    ("walls", c_double),
    ("rho", c_double),
    ("air", c_double),
    ("drag", c_double),
]
dom_scale._fields_ = [
    ("h", c_double),
    ("g", c_double),
]
dom_compute._fields_ = [
    ("tol", c_double),
    ("method", c_int),
    ("work", POINTER(dom_work)),
    ("interrupt", POINTER(c_int)),
]
dom_arithmetic._fields_ = [
    ("name", c_char_p),
    ("type", c_char_p),
    ("bits", c_int),
    ("epsilon", c_double),
    ("tol_default", c_double),
    ("tol_floor", c_double),
    ("digits", c_int),
]
dom_angles._fields_ = [
    ("theta_c", c_double),
    ("theta_u", c_double),
    ("theta_inf", c_double),
    ("theta_f", c_double),
    ("theta_leave", c_double),
    ("detaches", c_bool),
]
dom_contact._fields_ = [
    ("theta_1", c_double),
    ("slope", c_double),
    ("arm_a", c_double),
    ("arm_b", c_double),
]
dom_link._fields_ = [
    ("i", c_size_t),
    ("theta", c_double),
    ("slope", c_double),
    ("arm_a", c_double),
    ("arm_b", c_double),
    ("weight", c_double),
]
dom_visit = CFUNCTYPE(c_bool, POINTER(dom_link), c_void_p)
dom_energy._fields_ = [
    ("dH", c_double),
    ("J", c_double),
    ("J0", c_double),
]
dom_fuels._fields_ = [
    ("exact", c_double),
    ("paper", c_double),
]
dom_launch._fields_ = [
    ("fuel", c_double),
    ("J0", c_double),
    ("velocity_ratio", c_double),
    ("omegasq", c_double),
    ("kinetic", c_double),
]
dom_barrier._fields_ = [
    ("theta_m", c_double),
    ("barrier", c_double),
    ("kinetic", c_double),
    ("margin", c_double),
]
dom_event._fields_ = [
    ("kind", c_int),
    ("theta", c_double),
    ("time", c_double),
    ("domino", c_size_t),
]
dom_state._fields_ = [
    ("theta", c_double),
    ("time", c_double),
    ("omegasq", c_double),
    ("acceleration", c_double),
    ("kinetic", c_double),
    ("climbed", c_double),
    ("fallen", c_double),
    ("before", c_double),
    ("lost", c_double),
    ("friction_work", c_double),
]
dom_state_visit = CFUNCTYPE(c_bool, POINTER(dom_state), POINTER(dom_event), c_void_p)
dom_force._fields_ = [
    ("i", c_size_t),
    ("force", c_double),
    ("per_weight", c_double),
    ("impulse", c_double),
]
dom_force_visit = CFUNCTYPE(c_bool, POINTER(dom_force), c_void_p)
dom_least_force._fields_ = [
    ("force", c_double),
    ("theta", c_double),
    ("domino", c_size_t),
    ("impulse", c_double),
]
dom_floor._fields_ = [
    ("motion", c_double),
    ("theta", c_double),
    ("domino", c_size_t),
    ("hit", c_double),
    ("hit_domino", c_size_t),
]
dom_limit._fields_ = [
    ("r_max", c_double),
    ("ends", c_int),
    ("why", c_int),
    ("uncertainty", c_double),
    ("open", c_double),
]
dom_best._fields_ = [
    ("s", c_double),
    ("r_max", c_double),
    ("s_uncertainty", c_double),
    ("r_uncertainty", c_double),
]
dom_effect_argument._fields_ = [
    ("name", c_char_p),
    ("unit", c_char_p),
    ("meaning", c_char_p),
    ("lowest", c_double),
    ("highest", c_double),
    ("usual", c_double),
    ("optional", c_bool),
    ("whole", c_bool),
    ("or_file", c_char_p),
    ("words", POINTER(c_char_p)),
]
dom_effect._fields_ = [
    ("name", c_char_p),
    ("adds", c_char_p),
    ("help", c_char_p),
    ("source", c_char_p),
    ("plan", c_char_p),
    ("argument", dom_effect_argument * 3),
    ("needs", c_uint),
    ("dissipates", c_char_p),
    ("equations", POINTER(c_char_p)),
    ("cancels", c_bool),
    ("synonyms", c_char_p),
]
dom_box._fields_ = [
    ("filled", c_double),
    ("inertia", c_double),
]
dom_count._fields_ = [
    ("dominoes", c_double),
    ("exact", c_double),
    ("last", c_double),
]
dom_domino._fields_ = [
    ("height", c_double),
    ("thickness", c_double),
    ("gap", c_double),
    ("mass", c_double),
    ("radius", c_double),
    ("lean", c_double),
    ("width", c_double),
]
dom_row._fields_ = [
    ("domino", POINTER(dom_domino)),
    ("count", c_size_t),
    ("g", c_double),
    ("push", c_double),
    ("release", c_double),
    ("mu", c_double),
    ("alpha", c_double),
    ("walls", c_double),
    ("rho", c_double),
    ("air", c_double),
    ("drag", c_double),
    ("feet", c_double),
    ("floor", c_bool),
    ("engine", POINTER(dom_engine)),
    ("boxes_above", c_double),
]
dom_fall._fields_ = [
    ("domino", c_size_t),
    ("time", c_double),
    ("duration", c_double),
    ("omega", c_double),
    ("kinetic", c_double),
    ("barrier", c_double),
    ("margin", c_double),
    ("lost", c_double),
    ("friction_work", c_double),
    ("theta_m", c_double),
    ("theta", c_double),
    ("moving", c_size_t),
    ("floor_motion", c_double),
    ("floor_hit", c_double),
    ("floor_domino", c_size_t),
    ("floor_hit_domino", c_size_t),
]
dom_verdict._fields_ = [
    ("end", c_int),
    ("domino", c_size_t),
    ("short_by", c_double),
    ("seconds", c_double),
    ("weakest", c_size_t),
    ("spare", c_double),
]
dom_fall_visit = CFUNCTYPE(c_bool, POINTER(dom_fall), c_void_p)
dom_moment._fields_ = [
    ("time", c_double),
    ("head", c_size_t),
    ("moving", c_size_t),
    ("tilt", POINTER(c_double)),
    ("omega", POINTER(c_double)),
]
dom_moment_visit = CFUNCTYPE(c_bool, POINTER(dom_moment), c_void_p)
dom_row_runner = CFUNCTYPE(c_int, POINTER(dom_row), POINTER(dom_compute), c_bool, dom_fall_visit, c_void_p, POINTER(dom_verdict))
dom_engine._fields_ = [
    ("run", dom_row_runner),
    ("context", c_void_p),
]
dom_progress = CFUNCTYPE(None, c_size_t, c_size_t, c_void_p)
dom_row_make = CFUNCTYPE(None, c_double, POINTER(dom_domino), c_size_t, c_void_p)
dom_row_growth._fields_ = [
    ("r_max", c_double),
    ("r_min", c_double),
    ("ends", c_int),
]
dom_mend._fields_ = [
    ("domino", c_size_t),
    ("gap", c_double),
    ("to", c_double),
    ("until", c_double),
]
dom_window._fields_ = [
    ("domino", c_size_t),
    ("now", c_double),
    ("low", c_double),
    ("high", c_double),
    ("others", c_bool),
    ("below", c_int),
    ("above", c_int),
]
dom_limits._fields_ = [
    ("sizes", c_bool),
    ("q", c_double),
    ("hall", c_double),
    ("heaviest", c_double),
    ("grid", c_double),
    ("board", POINTER(c_double)),
    ("boards", c_size_t),
]
dom_wish._fields_ = [
    ("first", c_double),
    ("height", c_double),
    ("safety", c_double),
    ("hall", c_double),
    ("g", c_double),
    ("push", c_double),
    ("release", c_double),
    ("least", c_int),
    ("engine", POINTER(dom_engine)),
    ("walls", c_double),
    ("boxes_above", c_double),
]
dom_design._fields_ = [
    ("s", c_double),
    ("r", c_double),
    ("steps", c_size_t),
    ("feet", c_double),
    ("length", c_double),
    ("seconds", c_double),
    ("train", c_double),
    ("row", c_double),
    ("weakest", c_size_t),
    ("limit", c_int),
    ("needs", c_double),
]
dom_task = CFUNCTYPE(None, c_size_t, c_void_p)
dom_parallel = CFUNCTYPE(c_int, c_size_t, dom_task, c_void_p, c_void_p)
dom_random_error._fields_ = [
    ("size", c_double),
    ("uniform", c_bool),
]
dom_placement._fields_ = [
    ("error", dom_random_error * 11),
    ("seed", c_ulong),
    ("first", c_size_t),
    ("rows", c_size_t),
    ("parallel", dom_parallel),
    ("pool", c_void_p),
]
dom_study._fields_ = [
    ("rows", c_size_t),
    ("fall", c_size_t),
    ("unknown", c_size_t),
    ("low", c_double),
    ("high", c_double),
]
dom_budget._fields_ = [
    ("sigma", c_double),
    ("low", c_double),
    ("high", c_double),
]
dom_proof_work._fields_ = [
    ("boxes", c_size_t),
    ("chains", c_size_t),
]
dom_proof._fields_ = [
    ("ends", c_int),
    ("from", c_double),
    ("low", c_double),
    ("high", c_double),
    ("decimals", c_int),
    ("gap", c_int),
    ("work", dom_proof_work),
]
dom_interval._fields_ = [
    ("low", c_double),
    ("high", c_double),
]
dom_proof_cycle._fields_ = [
    ("verdict", c_int),
    ("kinetic", dom_interval),
    ("barrier", dom_interval),
    ("margin", dom_interval),
    ("gap", c_int),
    ("work", dom_proof_work),
]

# For each function the type of its result, and those of its parameters.
FUNCTIONS = {
    "dom_status_text": (c_char_p, [c_int]),
    "dom_end_text": (c_char_p, [c_int]),
    "dom_event_text": (c_char_p, [c_int]),
    "dom_version": (c_char_p, []),
    "dom_rmax": (c_double, [c_double, c_double, c_double]),
    "dom_dominoes": (c_double, [c_double, c_double, c_double]),
    "dom_speed": (c_double, [c_double, c_double, c_double]),
    "dom_train_default": (dom_train, []),
    "dom_scale_default": (dom_scale, []),
    "dom_compute_default": (dom_compute, []),
    "dom_arithmetic": (POINTER(dom_arithmetic), []),
    "dom_train_check": (c_int, [POINTER(dom_train), POINTER(dom_compute)]),
    "dom_train_reach": (c_double, [POINTER(dom_train)]),
    "dom_angles_find": (c_int, [POINTER(dom_train), POINTER(dom_compute), POINTER(dom_angles)]),
    "dom_contact_find": (c_int, [POINTER(dom_train), POINTER(dom_compute), c_double, POINTER(dom_contact)]),
    "dom_chain_walk": (c_int, [POINTER(dom_train), POINTER(dom_compute), c_double, dom_visit, c_void_p]),
    "dom_energy_find": (c_int, [POINTER(dom_train), POINTER(dom_compute), c_double, POINTER(dom_energy)]),
    "dom_fuel_find": (c_int, [POINTER(dom_train), POINTER(dom_compute), POINTER(dom_fuels)]),
    "dom_launch_find": (c_int, [POINTER(dom_train), POINTER(dom_compute), POINTER(dom_launch)]),
    "dom_barrier_find": (c_int, [POINTER(dom_train), POINTER(dom_compute), POINTER(dom_barrier)]),
    "dom_cycle_omegasq": (c_int, [POINTER(dom_train), POINTER(dom_compute), c_double, POINTER(c_double)]),
    "dom_cycle_stop": (c_int, [POINTER(dom_train), POINTER(dom_compute), POINTER(c_double)]),
    "dom_cycle_duration": (c_int, [POINTER(dom_train), POINTER(dom_compute), POINTER(c_double)]),
    "dom_cycle_events": (c_int, [POINTER(dom_train), POINTER(dom_compute), POINTER(dom_event), POINTER(c_int)]),
    "dom_cycle_state": (c_int, [POINTER(dom_train), POINTER(dom_compute), c_double, POINTER(dom_state)]),
    "dom_cycle_tilt": (c_int, [POINTER(dom_train), POINTER(dom_compute), c_double, POINTER(c_double)]),
    "dom_cycle_walk": (c_int, [POINTER(dom_train), POINTER(dom_compute), c_size_t, c_int, dom_state_visit, c_void_p]),
    "dom_cycle_forces": (c_int, [POINTER(dom_train), POINTER(dom_compute), c_double, dom_force_visit, c_void_p]),
    "dom_cycle_least_force": (c_int, [POINTER(dom_train), POINTER(dom_compute), POINTER(dom_least_force)]),
    "dom_cycle_floor": (c_int, [POINTER(dom_train), POINTER(dom_compute), POINTER(dom_floor)]),
    "dom_limit_rmax": (c_int, [POINTER(dom_train), POINTER(dom_compute), POINTER(dom_limit)]),
    "dom_limit_pair": (c_int, [POINTER(dom_train), POINTER(dom_compute), POINTER(dom_limit)]),
    "dom_limit_best": (c_int, [POINTER(dom_train), POINTER(dom_compute), POINTER(dom_best)]),
    "dom_trains_ask": (c_int, [c_int, POINTER(dom_train), POINTER(c_double), c_size_t, POINTER(dom_compute), c_void_p, POINTER(c_int)]),
    "dom_effect": (POINTER(dom_effect), [c_int]),
    "dom_first_effect": (POINTER(dom_effect), [POINTER(dom_train)]),
    "dom_law": (POINTER(dom_effect), [POINTER(dom_train)]),
    "dom_box_find": (c_int, [c_double, c_double, c_double, c_double, POINTER(dom_box)]),
    "dom_scale_tau": (c_double, [POINTER(dom_scale), POINTER(dom_train)]),
    "dom_scale_speed": (c_double, [POINTER(dom_scale), POINTER(dom_train), c_double]),
    "dom_count_find": (c_int, [c_double, c_double, c_double, POINTER(dom_count)]),
    "dom_row_end_text": (c_char_p, [c_int]),
    "dom_lean_limits": (None, [POINTER(dom_domino), c_double, c_double, POINTER(c_double)]),
    "dom_row_default": (dom_row, []),
    "dom_row_run": (c_int, [POINTER(dom_row), POINTER(dom_compute), c_bool, dom_fall_visit, c_void_p, POINTER(dom_verdict)]),
    "dom_row_touch": (c_int, [POINTER(dom_row), POINTER(dom_compute), POINTER(c_double)]),
    "dom_row_watch": (c_int, [POINTER(dom_row), POINTER(dom_compute), POINTER(c_double), c_size_t, dom_moment_visit, c_void_p, POINTER(dom_verdict)]),
    "dom_row_of_train": (None, [POINTER(dom_train), POINTER(dom_scale), c_double, POINTER(dom_domino), c_size_t]),
    "dom_row_rmax": (c_int, [POINTER(dom_row), POINTER(dom_compute), c_double, dom_row_make, c_void_p, POINTER(dom_row_growth)]),
    "dom_row_weakest_push": (c_int, [POINTER(dom_row), POINTER(dom_compute), c_double, POINTER(c_double)]),
    "dom_row_mend": (c_int, [POINTER(dom_row), POINTER(dom_compute), dom_progress, c_void_p, POINTER(dom_mend), POINTER(c_size_t)]),
    "dom_row_windows": (c_int, [POINTER(dom_row), POINTER(dom_compute), c_int, dom_progress, c_void_p, POINTER(dom_window)]),
    "dom_design_find": (c_int, [POINTER(dom_train), POINTER(dom_wish), POINTER(dom_compute), POINTER(dom_design)]),
    "dom_design_fit": (c_int, [POINTER(dom_train), POINTER(dom_wish), POINTER(dom_limits), POINTER(dom_compute), POINTER(dom_design)]),
    "dom_design_steps": (c_int, [POINTER(dom_train), POINTER(dom_wish), POINTER(dom_limits), POINTER(dom_compute), c_size_t, POINTER(dom_design)]),
    "dom_design_dominoes": (c_int, [POINTER(dom_train), POINTER(dom_wish), POINTER(dom_limits), POINTER(dom_design), POINTER(dom_domino)]),
    "dom_placement_study": (c_int, [POINTER(dom_row), POINTER(dom_compute), POINTER(dom_placement), POINTER(dom_study), POINTER(c_size_t)]),
    "dom_placement_causes": (c_int, [POINTER(dom_row), POINTER(dom_compute), POINTER(dom_placement), POINTER(dom_study), POINTER(c_size_t), POINTER(c_size_t)]),
    "dom_study_interval": (c_int, [POINTER(dom_study)]),
    "dom_placement_budget": (c_int, [POINTER(dom_row), POINTER(dom_compute), POINTER(dom_placement), c_int, c_double, POINTER(dom_budget)]),
    "dom_row_improve": (c_int, [POINTER(dom_row), POINTER(dom_compute), POINTER(dom_placement), POINTER(dom_limits), dom_progress, c_void_p, POINTER(dom_domino), POINTER(dom_study)]),
    "dom_proof_gap_text": (c_char_p, [c_int]),
    "dom_prove_rmax": (c_int, [POINTER(dom_train), POINTER(dom_compute), POINTER(dom_proof)]),
    "dom_prove_pair": (c_int, [POINTER(dom_train), POINTER(dom_compute), POINTER(dom_proof)]),
    "dom_prove_cycle": (c_int, [POINTER(dom_train), POINTER(dom_compute), POINTER(dom_proof_cycle)]),
    "dom_prove_count": (c_int, [c_double, c_double, c_double, POINTER(c_double), POINTER(c_double)]),
}
