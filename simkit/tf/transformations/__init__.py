"""Rotations and homogeneous matrices under the names of ROS 1's `tf.transformations`.

Points are columns, so `M = concatenate_matrices(T, R)` turns first and moves then; a matrix is
4x4 with the translation [m] in its last column. Quaternions are (x, y, z, w). Angles are
radians. Euler angles are given for one of 24 axis sequences: `sxyz`, the default, turns about
the fixed axes x, y, z in this order (roll, pitch, yaw); `r` instead of `s` turns with the body.

Functions hand out numpy arrays, and tuples of floats where tf does.

Source:
    The names, arguments and kinds of result are those of tf 1.13; the code is written from the
    mathematics.
"""

from simkit.tf.transformations.alignment import superimposition_matrix
from simkit.tf.transformations.arcball import (
    Arcball,
    arcball_constrain_to_axis,
    arcball_map_to_sphere,
    arcball_nearest_axis,
)
from simkit.tf.transformations.decomposition import (
    compose_matrix,
    decompose_matrix,
    orthogonalization_matrix,
)
from simkit.tf.transformations.euler import (
    euler_from_matrix,
    euler_from_quaternion,
    euler_matrix,
    quaternion_from_euler,
)
from simkit.tf.transformations.matrices import (
    concatenate_matrices,
    identity_matrix,
    inverse_matrix,
    is_same_transform,
    translation_from_matrix,
    translation_matrix,
)
from simkit.tf.transformations.mirrors import (
    reflection_from_matrix,
    reflection_matrix,
    scale_from_matrix,
    scale_matrix,
    shear_from_matrix,
    shear_matrix,
)
from simkit.tf.transformations.projections import (
    clip_matrix,
    projection_from_matrix,
    projection_matrix,
)
from simkit.tf.transformations.quaternions import (
    quaternion_about_axis,
    quaternion_conjugate,
    quaternion_from_matrix,
    quaternion_inverse,
    quaternion_matrix,
    quaternion_multiply,
    quaternion_slerp,
)
from simkit.tf.transformations.rotations import rotation_from_matrix, rotation_matrix
from simkit.tf.transformations.sampling import (
    random_quaternion,
    random_rotation_matrix,
    random_vector,
)
from simkit.tf.transformations.vectors import unit_vector, vector_norm

__all__ = [
    "Arcball",
    "arcball_constrain_to_axis",
    "arcball_map_to_sphere",
    "arcball_nearest_axis",
    "clip_matrix",
    "compose_matrix",
    "concatenate_matrices",
    "decompose_matrix",
    "euler_from_matrix",
    "euler_from_quaternion",
    "euler_matrix",
    "identity_matrix",
    "inverse_matrix",
    "is_same_transform",
    "orthogonalization_matrix",
    "projection_from_matrix",
    "projection_matrix",
    "quaternion_about_axis",
    "quaternion_conjugate",
    "quaternion_from_euler",
    "quaternion_from_matrix",
    "quaternion_inverse",
    "quaternion_matrix",
    "quaternion_multiply",
    "quaternion_slerp",
    "random_quaternion",
    "random_rotation_matrix",
    "random_vector",
    "reflection_from_matrix",
    "reflection_matrix",
    "rotation_from_matrix",
    "rotation_matrix",
    "scale_from_matrix",
    "scale_matrix",
    "shear_from_matrix",
    "shear_matrix",
    "superimposition_matrix",
    "translation_from_matrix",
    "translation_matrix",
    "unit_vector",
    "vector_norm",
]
