"""The text of a matrix, as programs, debuggers and people write it."""

import json
import time
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.model.matrix_text import LONGEST, read_matrix
from app.model.refusal import Refusal

VIEW: list[list[float]] = [[1.0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, -5.25], [0, 0, 0, 1]]
MATLAB = """V =

    1.0000         0         0         0
         0    1.0000         0         0
         0         0    1.0000   -5.2500
         0         0         0    1.0000
"""
MATLAB_FACTOR = """V =

   1.0e+03 *

    0.0010         0         0         0
         0    0.0010         0         0
         0         0    0.0010   -0.00525
         0         0         0    0.0010
"""
MATLAB_COLUMNS = """V =

  Columns 1 through 3

     1     0     0
     0     1     0
     0     0     1
     0     0     0

  Column 4

         0
         0
   -5.2500
    1.0000
"""
LATEX = r"""% needs \usepackage{amsmath}
\[
M_{\text{view}\leftarrow\text{world}} = \begin{pmatrix}
1 & 0 & \phantom{-}0 & 0 \\
0 & 1 & 0 & 0 \\[2pt]
0 & 0 & 1 & -5.25 \cdot 10^{0} \\
0 & 0 & 0 & 1
\end{pmatrix}
\]
"""
LLDB = """(glm::mat<4, 4, float, glm::packed_highp>) $0 = {
  value = {
    [0] = (x = 1, y = 0, z = 0, w = 0)
    [1] = (x = 0, y = 1, z = 0, w = 0)
    [2] = (x = 0, y = 0, z = 1, w = -5.25)
    [3] = (x = 0, y = 0, z = 0, w = 1)
  }
}"""
UNITY_JSON = (
    '{"e00":1.0,"e10":0.0,"e20":0.0,"e30":0.0,"e01":0.0,"e11":1.0,"e21":0.0,"e31":0.0,'
    '"e02":0.0,"e12":0.0,"e22":1.0,"e32":0.0,"e03":0.0,"e13":0.0,"e23":-5.25,"e33":1.0}'
)
BLENDER = """<Matrix 4x4 (1.0000, 0.0000, 0.0000,  0.0000)
            (0.0000, 1.0000, 0.0000,  0.0000)
            (0.0000, 0.0000, 1.0000, -5.2500)
            (0.0000, 0.0000, 0.0000,  1.0000)>"""
R = """     [,1] [,2] [,3]  [,4]
[1,]    1    0    0  0.00
[2,]    0    1    0  0.00
[3,]    0    0    1 -5.25
[4,]    0    0    0  1.00"""
EIGEN_IN_GDB = (
    "$1 = {<Eigen::PlainObjectBase<Eigen::Matrix<double, 4, 4, 1, 4, 4> >> = {m_storage = "
    "{m_data = {array = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -5.25, 0, 0, 0, 1}}}}, <No data fields>}"
)
AS_WRITTEN = {
    "numpy": repr(np.array(VIEW)),
    "numpy float32": repr(np.array(VIEW, dtype=np.float32)),
    "numpy printed": str(np.array(VIEW)),
    "numpy scalars": str([[np.float32(x) for x in row] for row in VIEW]),
    "a statement": "view = np.array([  # the camera of 2026\n    [1.0, 0.0, 0.0, 0.0],\n"
                   "    [0, 1, 0, 0],\n    [0, 0, 1, -5.25],\n    [0, 0, 0, 1],\n])\n",
    "json": json.dumps({"view_from_world": VIEW}),
    "torch": "tensor([[1., 0., 0., 0.],\n        [0., 1., 0., 0.],\n"
             "        [0., 0., 1., -5.2500],\n"
             "        [0., 0., 0., 1.]], device='cuda:0', dtype=torch.float64)",
    "tensorflow": "<tf.Tensor: shape=(4, 4), dtype=float32, numpy=\n"
                  f"{np.array(VIEW, dtype=np.float32)!r}>",
    "C": "float m[4][4] = {{1.f,0,0,0},{0,1.0F,0,0},{0,0,1,-5.25f},{0,0,0,1}}; // row 0\n",
    "C++": "std::array<float, 16> a{/* 4x4 */ 1,0,0,0, 0,1,0,0, 0,0,1,-5.25f, 0,0,0,1};",
    "Rust": "let m: [[f32; 4]; 4] = [[1.0_f32,0.,0.,0.],[0.,1.,0.,0.],[0.,0.,1.,-5.25f32],"
            "[0.,0.,0.,1.]];",
    "MATLAB typed": "P = [1 0 0 0; 0 1 0 0; 0 0 1 -5.25; ...\n0 0 0 1];",
    "MATLAB": MATLAB,
    "MATLAB factor": MATLAB_FACTOR,
    "MATLAB columns": MATLAB_COLUMNS,
    "LaTeX": LATEX,
    "LaTeX array": r"\left[\begin{array}{cccc} 1 & 0 & 0 & 0 \\ 0 & 1 & 0 & 0 \\"
                   r"0 & 0 & 1 & -\frac{21}{4} \\ 0 & 0 & 0 & 1 \end{array}\right]",
    "LaTeX spaced": r"1&0&0&0 \cr 0&1&0&0 \cr 0&0&1& - 5.25 \cr 0&0&0&1",
    "gdb": "$1 = {m = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, -5.25}, {0, 0, 0, 1}}}",
    "gdb at": "(float (&)[4][4]) @0x7ffd5c3e: {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, -5.25},"
              " {0, 0, 0, 1}}",
    "gdb Eigen": EIGEN_IN_GDB,
    "lldb": LLDB,
    "HLSL": "float4x4 view = float4x4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -5.25, 0, 0, 0, 1);",
    "Swift rows": "float4x4(rows: [SIMD4<Float>(1,0,0,0), SIMD4<Float>(0,1,0,0), "
                  "SIMD4<Float>(0,0,1,-5.25), SIMD4<Float>(0,0,0,1)])",
    "three.js rows": "new THREE.Matrix4().set(1,0,0,0,0,1,0,0,0,0,1,-5.25,0,0,0,1)",
    "OpenCV": "cv::Mat V = (cv::Mat_<double>(4, 4) << 1,0,0,0,0,1,0,0,0,0,1,-5.25,0,0,0,1);",
    "prose of elements": "the elements of my matrix are:\n1 0 0 0\n0 1 0 0\n0 0 1 -5.25\n0 0 0 1",
    "a matrix called inverse": "inverse = [1 0 0 0; 0 1 0 0; 0 0 1 -5.25; 0 0 0 1]",
    "names with indices": "m00 = 1 m10 = 0 m20=0 m30=0 m01=0 m11=1 m21=0 m31=0 m02=0 m12=0 m22=1 "
                          "m32=0 m03=0 m13=0 m23=-5.25 m33=1",
    "cells": "\n".join(f"m[{i}][{j}] = {VIEW[i][j]};" for i in range(4) for j in range(4)),
    "Unity": "\n".join("\t".join(f"{x:.5f}" for x in row) for row in VIEW) + "\n",
    "Unity JSON": UNITY_JSON,
    "Blender": BLENDER,
    "Julia": "4×4 Matrix{Float64}:\n 1.0  0.0  0.0   0.0\n 0.0  1.0  0.0   0.0\n"
             " 0.0  0.0  1.0  -5.25\n 0.0  0.0  0.0   1.0",
    "R": R,
    "Mathematica": "{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, -525*^-2}, {0, 0, 0, 1}}",
    "Fortran": "1.0D+00 0 0 0 0 1 0 0 0 0 1 -5.25D+00 0 0 0 1",
    "Unicode": "⎡1  0  0  0  ⎤\n⎢0  1  0  0  ⎥\n⎢0  0  1  −21/4⎥\n⎣0  0  0  1  ⎦",
    "nalgebra printed": "\n  ┌                ┐\n  │ 1 0 0     0 │\n  │ 0 1 0     0 │\n"
                        "  │ 0 0 1 -5.25 │\n  │ 0 0 0     1 │\n  └                ┘\n",
    "powers": "1 0 0 0\n0 1 0 0\n0 0 1 -52.5·10⁻¹\n0 0 0 1",
    "a table": "| 1 | 0 | 0 | 0 |\n| 0 | 1 | 0 | 0 |\n| 0 | 0 | 1 | -5.25 |\n| 0 | 0 | 0 | 1 |",
    "quoted": '"1","0","0","0"\r\n"0","1","0","0"\r\n"0","0","1","-5.25"\r\n"0","0","0","1"\r\n',
    "decimal commas": "1,0 0,0 0,0 0,0\n0,0 1,0 0,0 0,0\n0,0 0,0 1,0 -5,25\n0,0 0,0 0,0 1,0",
    "Excel": "1;0;0;0\n0;1;0;0\n0;0;1;-5,25\n0;0;0;1",
    "commas only": "1,0,0,0,0,1,0,0,0,0,1,-5.25,0,0,0,1",
    "marked UTF-8": "\ufeff1 0 0 0 0 1 0 0 0 0 1 -5.25 0 0 0 1",
    "Eigen typed": "Eigen::Matrix4d m; m << 1, 0, 0, 0,\n 0, 1, 0, 0,\n 0, 0, 1, -5.25,\n"
                   " 0, 0, 0, 1;",
    "Java": "double[][] m = new double[][]{{1.0d,0,0,0},{0,1,0,0},{0,0,1,-5.25d},{0,0,0,1}};",
    "YAML": "view:\n  - [1, 0, 0, 0]\n  - [0, 1, 0, 0]\n  - [0, 0, 1, -5.25]\n  - [0, 0, 0, 1]\n",
    "C#": "{ {M11:1 M12:0 M13:0 M14:0} {M21:0 M22:1 M23:0 M24:0} {M31:0 M32:0 M33:1 M34:-5.25} "
          "{M41:0 M42:0 M43:0 M44:1} }",
    "a factor": "0.5 * np.array([[2,0,0,0],[0,2,0,0],[0,0,2,-10.5],[0,0,0,2]])",
    "prose": "my view matrix (in a log) is:\n1 0 0 0\n0 1 0 0\n0 0 1 -5.25\n0 0 0 1",
    "XML": "<matrix>1 0 0 0 0 1 0 0 0 0 1 -5.25 0 0 0 1</matrix>",
    "JavaScript": "Float32Array(16) [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -5.25, 0, 0, 0, 1]",
}  # fmt: skip
BY_COLUMNS = {
    "glm": "mat4x4((1,0,0,0),(0,1,0,0),(0,0,1,0),(0,0,-5.25,1))",
    "GLSL": "const mat4 m = mat4(1.0f, 0.,0,0, 0,1,0,0, 0,0,1,0, 0,0,-5.25,1);",
    "WGSL": "mat4x4<f32>(1.0, 0.0, 0.0, 0.0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -5.25, 1)",
    "CSS": "matrix3d(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -5.25, 1)",
    "three.js": '{"metadata": {}, "elements": [1,0,0,0,0,1,0,0,0,0,1,0,0,0,-5.25,1]}',
    "glam": "Mat4 { x_axis: Vec4(1.0, 0.0, 0.0, 0.0), y_axis: Vec4(0.0, 1.0, 0.0, 0.0), "
            "z_axis: Vec4(0.0, 0.0, 1.0, 0.0), w_axis: Vec4(0.0, 0.0, -5.25, 1.0) }",
    "glm variable": "glm::mat4 view(1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,-5.25f,1);",
    "glm braces": "const mat4 view = {{1,0,0,0}, {0,1,0,0}, {0,0,1,0}, {0,0,-5.25f,1}};",
    "glm columns": "m[0] = glm::vec4(1,0,0,0); m[1] = glm::vec4(0,1,0,0);\n"
                   "m[2] = glm::vec4(0,0,1,0); m[3] = glm::vec4(0,0,-5.25,1);",
    "glMatrix": "mat4.fromValues(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -5.25, 1)",
    "WGSL short": "mat4x4f(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -5.25, 1)",
    "DOM": "new DOMMatrix([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -5.25, 1])",
    "three.js array": "new THREE.Matrix4().fromArray([1,0,0,0,0,1,0,0,0,0,1,0,0,0,-5.25,1])",
    "three.js elements": "camera.matrixWorld.elements = [1,0,0,0,0,1,0,0,0,0,1,0,0,0,-5.25,1];",
    "Unity": "new Matrix4x4(new Vector4(1,0,0,0), new Vector4(0,1,0,0),\n"
             "    new Vector4(0,0,1,0), new Vector4(0,0,-5.25f,1))",
    "SetColumn": "m.SetColumn(0, new Vector4(1,0,0,0)); m.SetColumn(1, new Vector4(0,1,0,0));\n"
                 "m.SetColumn(2, new Vector4(0,0,1,0)); m.SetColumn(3, new Vector4(0,0,-5.25f,1));",
    "glam array": "DMat4::from_cols_array(&[1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,0.,0.,0.,-5.25,1.])",
    "nalgebra": "Matrix4::from_column_slice(&[1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,0.,0.,0.,-5.25,1.])",
    "Swift": "simd_float4x4([[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], "
             "[0.0, 0.0, -5.25, 1.0]])",
    "Swift columns": "float4x4(columns: (SIMD4<Float>(1,0,0,0), SIMD4<Float>(0,1,0,0), "
                     "SIMD4<Float>(0,0,1,0), SIMD4<Float>(0,0,-5.25,1)))",
    "Godot": "Projection(Vector4(1,0,0,0), Vector4(0,1,0,0), Vector4(0,0,1,0), "
             "Vector4(0,0,-5.25,1))",
    "gdb Eigen": EIGEN_IN_GDB.replace("4, 4, 1", "4, 4, 0").replace(
        "-5.25, 0, 0, 0", "0, 0, 0, -5.25"
    ),
    "a comment": "float m[16] = {1,0,0,0,0,1,0,0,0,0,1,0,0,0,-5.25f,1}; // column-major",
}  # fmt: skip


@pytest.mark.parametrize("writer", AS_WRITTEN)
def test_a_matrix_is_read_as_it_is_written(writer: str) -> None:
    assert read_matrix(AS_WRITTEN[writer]) == VIEW


@pytest.mark.parametrize("writer", BY_COLUMNS)
def test_a_notation_with_columns_first_is_transposed(writer: str) -> None:
    assert read_matrix(BY_COLUMNS[writer]) == VIEW


@pytest.mark.parametrize(
    ("text", "rows"),
    [
        ("1 0 0 0 1 0 0 0 1", np.eye(3).tolist()),
        ("1/2 0 0 0 1 0 0 0 -5/2", [[0.5, 0, 0], [0, 1, 0], [0, 0, -2.5]]),
        ("1,5;0;0;0;2,5;0;0;0;1", [[1.5, 0, 0], [0, 2.5, 0], [0, 0, 1]]),
        ("1 0 0 7\n0 1 0 8\n0 0 1 9\n", [[1, 0, 0, 7], [0, 1, 0, 8], [0, 0, 1, 9]]),
        ("1 0 0 7 0 1 0 8 0 0 1 9", [[1, 0, 0, 7], [0, 1, 0, 8], [0, 0, 1, 9]]),
        ("mat4x3(1, 0, 0, 0, 1, 0, 0, 0, 1, 7, 8, 9)", [[1, 0, 0, 7], [0, 1, 0, 8], [0, 0, 1, 9]]),
        ("float4x3(1, 0, 0, 0, 1, 0, 0, 0, 1, 7, 8, 9)",
         [[1, 0, 0], [0, 1, 0], [0, 0, 1], [7, 8, 9]]),
        ("cv::Mat K = (cv::Mat_<int>(3,3) << 8, 0, 3, 0, 8, 2, 0, 0, 1);",
         [[8, 0, 3], [0, 8, 2], [0, 0, 1]]),
        ("[X: (1, 0, 0), Y: (0, 1, 0), Z: (0, 0, 1), O: (7, 8, 9)]",
         [[1, 0, 0], [0, 1, 0], [0, 0, 1], [7, 8, 9]]),
        ("%YAML:1.0\n---\nK: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 800., "
         "0., 320., 0.,\n       800., 240., 0., 0., 1. ]\n",
         [[800, 0, 320], [0, 800, 240], [0, 0, 1]]),
        ("K:\n" + "".join(f"  - {x}\n" for x in (800, 0, "-1.5", 0, 800, 240, 0, 0, 1)),
         [[800, 0, -1.5], [0, 800, 240], [0, 0, 1]]),
        ("R:\n" + "".join(f"- - {x}\n  - 2\n  - -.5\n" for x in (1, 4, 7, 10)),
         [[1, 2, -0.5], [4, 2, -0.5], [7, 2, -0.5], [10, 2, -0.5]]),
        ("     0    1      2\n0  1.0  0.0  320.0\n1  0.0  1.0  240.0\n2  0.0  0.0    1.0",
         [[1, 0, 320], [0, 1, 240], [0, 0, 1]]),
        ("   x  y  z\n0  1  0  7\n1  0  1  8\n2  0  0  1", [[1, 0, 7], [0, 1, 8], [0, 0, 1]]),
        ("   x  y  z\n0  1  0  0\n1  0  1  0\n2  0  0  1\n3  7  8  9",
         [[1, 0, 0], [0, 1, 0], [0, 0, 1], [7, 8, 9]]),
        ("my view matrix\n0 1 0 7\n-1 0 0 8\n0 0 1 9", [[0, 1, 0, 7], [-1, 0, 0, 8], [0, 0, 1, 9]]),
        ("   x  y  z  w\n0  1  0  0  7\n1  0  1  0  8\n2  0  0  1  9\n3  0  0  0  1",
         [[1, 0, 0, 7], [0, 1, 0, 8], [0, 0, 1, 9], [0, 0, 0, 1]]),
    ],
)  # fmt: skip
def test_three_rows_are_read_too(text: str, rows: Any) -> None:
    assert read_matrix(text) == rows


@pytest.mark.parametrize(
    ("text", "bound"),
    [
        ("1 2 3", "must be 9, 12 or 16 numbers, but has 3"),
        ("", "must be 9, 12 or 16 numbers, but has 0"),
        ("1 " * 17, "must be 9, 12 or 16 numbers, but has 17"),
        ("nan 0 0 0 1 0 0 0 1", "must be a matrix of finite numbers, but has nan"),
        ("1e999 0 0 0 1 0 0 0 1", "must be a matrix of finite numbers, but has 1e999"),
        ("1 0 0 0 1 0 0 0 -∞", "must be a matrix of finite numbers, but has -∞"),
        ("1 0 0 0 1 0 0 0 -1.#IND", "must be a matrix of finite numbers, but has -1.#IND"),
        ("1/0 0 0 0 1 0 0 0 1", "must be a matrix of numbers, but has 1/0"),
        ("cos(0.3) 0 0 0 1 0 0 0 1", r"must be a matrix of numbers, but has cos\(...\)"),
        (r"\sqrt{3} & 0 & 0 \\ 0&1&0\\0&0&1", r"numbers, but has sqrt\(...\)"),
        ("√3 0 0 0 1 0 0 0 1", "numbers, but has √3"),
        ("30° 0 0 0 1 0 0 0 1", "numbers, but has °"),
        ("1 0 0 0 1 0 0 0 a", "numbers, but has a"),
        ("a 1 0 0 0 1 0 0 0", "numbers, but has a"),
        ("1 0 0 0 1 0 0 0 2-1", "numbers, but has 2-1"),
        ("1 0 0 0 1 0 0 0 2 - 1", "numbers, but has -"),
        ("1 0 0 0 1 0 0 0 2*3", r"numbers, but has \*"),
        ("0x10 0 0 0 1 0 0 0 1", "numbers, but has 0x10"),
        ("np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1]]).T", "numbers, but has .T"),
        ("np.linalg.inv([[1, 0, 0], [0, 1, 0], [0, 0, 1]])", r"has np.linalg.inv\(...\)"),
        ("glm::inverse(glm::mat3(1, 0, 0, 0, 1, 0, 0, 0, 1))", r"has glm::inverse\(...\)"),
        ("np.hstack(([[1, 0, 0], [0, 1, 0], [0, 0, 1]], [[7], [8], [9]]))", r"np.hstack\(...\)"),
        ("np.column_stack(([1, 0, 0], [0, 1, 0], [0, 0, 1]))", r"np.column_stack\(...\)"),
        ("XMMatrixTranspose(XMMATRIX(" + "1, " * 15 + "1))", r"has XMMatrixTranspose\(...\)"),
        ("[1 0 0; 0 1 0; 0 0 1]'", "numbers, but has '"),
        ("1,5 0 0 0 0,5 0 0 0 1,5", "9 numbers with decimal commas or as 12 numbers"),
        ("1 0 0\n" * 10_000, f"up to {LONGEST} characters"),
    ],
)  # fmt: skip
def test_what_is_not_understood_is_named(text: str, bound: str) -> None:
    with pytest.raises(Refusal, match=f"^view = .*{bound}.*[.]$"):
        read_matrix(text, "view")


@given(st.lists(st.floats(-1e100, 1e100), min_size=16, max_size=16),
       st.sampled_from(("{!r}", "{:.17g}", "{:.16e}")),
       st.sampled_from((" ", ", ", ";", "\t", " & ", "\n")))  # fmt: skip
def test_every_float64_survives(numbers: list[float], form: str, between: str) -> None:
    text = between.join(form.format(number) for number in numbers)
    rows = read_matrix(text)
    assert [number for row in rows for number in row] == numbers


HOSTILE = (
    "9", "[", "1,", "-", "a ", "<", "<a", "/*", "\\\\[", "1/", '"', "'a", "\\frac{", "[1", "a[1]",
    "a::", "Columns 1 ", "1.#", "1e", "·10^", "shape=(", "(16) ", ".", "1x", "\n", "1,1 ", "⁻", "!",
    "&*", "0x", "$", "1 2 3 4\n", "m00=1 ", "# ", "//", "nan(", "\\begin{", "\\phantom{", "[[f32; ",
)  # fmt: skip


@pytest.mark.parametrize("part", HOSTILE)
def test_hostile_text_is_refused_quickly(part: str) -> None:
    started = time.process_time()
    with pytest.raises(Refusal):
        read_matrix(part * (LONGEST // len(part)))
    with pytest.raises(Refusal):
        read_matrix(part * (1_000_000 // len(part)))
    assert time.process_time() - started < 2.0
