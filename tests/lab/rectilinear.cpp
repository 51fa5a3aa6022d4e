#include "lab/rectilinear.hpp"

#include <gtest/gtest.h>

namespace mpm {
namespace {

const Rectilinear<2> graded({Lines{0, 1, 3}, Lines{0, 0.5, 0.75, 2}}, Sharing{3, 2});

TEST(Rectilinear, CountsElementsAndNodes) {
    EXPECT_EQ(graded.elements(), 6);
    EXPECT_EQ(graded.nodes(0), 5);
    EXPECT_EQ(graded.nodes(1), 7);
    EXPECT_EQ(graded.size(), 35);
}
TEST(Rectilinear, NeighboursShareTheNodesBetweenThem) {
    for (int j = 0; j < 3; ++j) EXPECT_EQ(graded.node(0, 3 * j + 2), graded.node(1, 3 * j));
    for (int i = 0; i < 3; ++i) EXPECT_EQ(graded.node(0, 6 + i), graded.node(2, i));
}
TEST(Rectilinear, NodesLieOnLinesAndHalfwayBetween) {
    EXPECT_EQ(graded.position(graded.node(3, 4)), Vec<2>(2, 0.625));
    EXPECT_EQ(graded.position(graded.node(5, 8)), Vec<2>(3, 2));
}
TEST(Rectilinear, FindsTheElementOfAPoint) {
    EXPECT_EQ(graded.element_at({0.5, 0.6}), 2);
    EXPECT_EQ(graded.element_at({1, 0.5}), 3);   // between two: the one with the larger number
    EXPECT_EQ(graded.element_at({3, 2}), 5);     // the upper corner belongs to the last
    EXPECT_THROW(graded.element_at({3.1, 1}), OutsideGrid);
    EXPECT_THROW(graded.element_at({std::nan(""), 1}), OutsideGrid);
}
TEST(Rectilinear, HalvingKeepsTheLines) {
    EXPECT_EQ(halved({0, 1, 3}, 2), (Lines{0, 0.25, 0.5, 0.75, 1, 1.5, 2, 2.5, 3}));
}

}  // namespace
}  // namespace mpm
