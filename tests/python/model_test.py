"""The model as arrays."""

import gc
import unittest

import numpy as np
from support import tiny_case


class Arrays(unittest.TestCase):
    def setUp(self):
        self.model = tiny_case().model()

    def test_shapes_and_types(self):
        n, m = 122, 120  # 2 N W C elements, a node more in each of 2 courses: N = 10, W = 3, C = 2
        model = self.model
        for name, shape, kind in (
            ("nodes", (n, 3), np.float64),
            ("tangents", (n, 3), np.float64),
            ("arc_length", (n,), np.float64),
            ("course", (n,), np.int32),
            ("wale", (n,), np.int32),
            ("yarn_of_node", (n,), np.int32),
            ("elements", (m, 2), np.int32),
            ("yarn_of_element", (m,), np.int32),
            ("radius", (m,), np.float64),
            ("tie_elements", (0, 2), np.int32),
            ("tie_shares", (0, 2), np.float64),
        ):
            array = getattr(model, name)
            self.assertEqual((array.shape, array.dtype), (shape, kind), name)
            self.assertFalse(array.flags.writeable, name)

    def test_elements_join_the_nodes_of_one_yarn(self):
        model = self.model
        first, second = model.elements.T
        np.testing.assert_array_equal(second, first + 1)
        np.testing.assert_array_equal(model.yarn_of_node[first], model.yarn_of_node[second])
        np.testing.assert_array_equal(model.yarn_of_element, model.yarn_of_node[first])
        np.testing.assert_array_equal(np.bincount(model.yarn_of_element), [60, 60])

    def test_units_are_millimetres(self):
        model = self.model
        self.assertAlmostEqual(model.gauge_length, 12.0)  # T + H = 5 mm + 7 mm
        self.assertAlmostEqual(np.ptp(model.nodes[:, 1]), model.gauge_length)
        np.testing.assert_allclose(model.radius, 0.06)
        np.testing.assert_allclose(np.linalg.norm(model.tangents, axis=1), 1)

    def test_node_sets(self):
        sets = self.model.node_sets
        self.assertEqual(set(sets), {"bottom_feet", "top_heads", "left_edge", "right_edge"})
        y = self.model.nodes[:, 1]
        self.assertLess(y[sets["bottom_feet"]].max(), y[sets["top_heads"]].min())

    def test_ties_join_places_that_are_near(self):
        case = tiny_case()
        case["fabric.structure"] = "tied"
        model = case.model()
        self.assertEqual(model.tie_elements.shape, (8, 2))
        ends = model.nodes[model.elements[model.tie_elements]]  # tie, side, end, xyz
        share = model.tie_shares[:, :, None]
        places = ends[:, :, 0] * (1 - share) + ends[:, :, 1] * share
        distance = np.linalg.norm(places[:, 0] - places[:, 1], axis=1)
        self.assertLess(distance.max(), 0.12 * 1.5)  # of a yarn of 0.12 mm, on chords

    def test_arrays_outlive_their_model(self):
        case = tiny_case()
        nodes = case.model().nodes
        feet = case.model().node_sets["bottom_feet"]
        gc.collect()
        others = [case.model() for _ in range(5)]  # which would take the memory, were it free
        np.testing.assert_array_equal(nodes, self.model.nodes)
        np.testing.assert_array_equal(feet, self.model.node_sets["bottom_feet"])
        self.assertEqual(len(others), 5)

    def test_a_copy_may_be_changed(self):
        with self.assertRaises(ValueError):
            self.model.nodes[0, 0] = 1
        nodes = self.model.nodes.copy()
        nodes[0, 0] = 1
        self.assertEqual(nodes[0, 0], 1)
