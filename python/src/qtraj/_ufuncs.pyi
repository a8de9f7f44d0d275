import numpy as np

slerp_shortest: np.ufunc
slerp_as_given: np.ufunc
nlerp_shortest: np.ufunc
nlerp_as_given: np.ufunc
slerp_between_shortest: np.ufunc
slerp_between_as_given: np.ufunc
nlerp_between_shortest: np.ufunc
nlerp_between_as_given: np.ufunc
screw: np.ufunc
multiply: np.ufunc
rotate: np.ufunc
distance: np.ufunc
dot: np.ufunc
angle: np.ufunc
power: np.ufunc
exp: np.ufunc
log: np.ufunc
rotation_vector_from_q: np.ufunc
q_from_rotation_vector: np.ufunc
matrix_from_q: np.ufunc
normalize: np.ufunc
wxyz_from_xyzw: np.ufunc
xyzw_from_wxyz: np.ufunc
conjugate: np.ufunc
inverse: np.ufunc
norm: np.ufunc
q_from_matrix: np.ufunc
derivatives_body: np.ufunc
derivatives_world: np.ufunc
rates_body: np.ufunc
rates_world: np.ufunc
squad_segment: np.ufunc
mean_from_moments: np.ufunc
sample: np.ufunc

def take_ambiguous() -> bool: ...
