// SPDX-License-Identifier: MIT
// Core exercise 09 walk: what a ray does at a node.

// kernels/tree.cl
// #region children
        // your turn: given are node, t, bottom, count, nodes and enters; scene, ray and closest
        for (int child = 0; child < 2; ++child) {
            if (t[child] >= 0.0f && node->count[child] != 0) {
                try_leaf(scene, ray, node->first[child], node->count[child], closest);
            } else if (t[child] >= 0.0f) {
                nodes[count] = node->first[child];
                enters[count++] = t[child];
            }
        }
// #endregion children
