#pragma once

#include "../types.h"

#include <vector>

namespace braidx {

/// Box with sides along the axes.
struct Box {
    Vec3 low, high;

    static Box around(const Vec3& a, const Vec3& b) { return {a.cwiseMin(b), a.cwiseMax(b)}; }

    Box inflated(double by) const { return {low - Vec3::Constant(by), high + Vec3::Constant(by)}; }
    Box joined(const Box& other) const {
        return {low.cwiseMin(other.low), high.cwiseMax(other.high)};
    }
    bool meets(const Box& other) const {
        return (low.array() <= other.high.array()).all() &&
               (other.low.array() <= high.array()).all();
    }
    double distance_to(const Vec3& x) const {
        return (low - x).cwiseMax(x - high).cwiseMax(0.0).norm();
    }
};

/// Boxes of any sizes in a binary tree of boxes (bounding volume hierarchy), split at the median
/// centre.
class BoxTree {
public:
    /// Coordinates of boxes are finite.
    explicit BoxTree(const std::vector<Box>& boxes);

    /// Calls visit(i) for every box i that meets `box`. Returns how many boxes were tested.
    template <class Visit> std::size_t for_each_meeting(const Box& box, const Visit& visit) const {
        return nodes_.empty() ? 0 : search(0, box, visit);
    }

private:
    /// The first child of an inner node is the node that follows it.
    struct Node {
        Box box;
        std::size_t second; ///< second child; 0 at a leaf
        std::int32_t item;  ///< number of the box at a leaf
    };
    struct Item {
        Box box;
        std::int32_t number;
    };

    void build(std::vector<Item>& items, std::size_t begin, std::size_t end);

    template <class Visit>
    std::size_t search(std::size_t at, const Box& box, const Visit& visit) const {
        const Node& node = nodes_[at];
        if (!node.box.meets(box))
            return 1;
        if (node.second == 0) {
            visit(node.item);
            return 1;
        }
        return 1 + search(at + 1, box, visit) + search(node.second, box, visit);
    }

    std::vector<Node> nodes_;
};

} // namespace braidx
