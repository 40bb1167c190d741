#include "search/box_tree.h"
#include "support/random.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace braidx;
using namespace braidx::test;

namespace {

/// Boxes whose sizes differ by up to a thousand.
std::vector<Box> random_boxes(Random& random, int count) {
    std::vector<Box> out;
    for (int i = 0; i < count; ++i) {
        const Vec3 centre = random.vector(5);
        const double size = std::pow(10, random.uniform(-2, 1));
        out.push_back(Box::around(centre - random.vector(size), centre + random.vector(size)));
    }
    return out;
}

bool apart(const Box& a, const Box& b) {
    for (int i = 0; i < 3; ++i)
        if (a.high[i] < b.low[i] || b.high[i] < a.low[i])
            return true;
    return false;
}

} // namespace

TEST_CASE("a tree of boxes gives those that meet a box, each once", "[box_tree]") {
    Random random(4);
    for (const int count : {0, 1, 2, 3, 17, 300}) {
        auto boxes = random_boxes(random, count);
        for (int copy = 0; copy < count / 10; ++copy) // some of them alike
            boxes.push_back(boxes.front());
        const BoxTree tree(boxes);
        for (const auto& asked : random_boxes(random, 50)) {
            std::vector<std::int32_t> found, wanted;
            tree.for_each_meeting(asked, [&](std::int32_t i) { found.push_back(i); });
            for (std::size_t i = 0; i < boxes.size(); ++i)
                if (!apart(boxes[i], asked))
                    wanted.push_back(static_cast<std::int32_t>(i));
            std::ranges::sort(found);
            REQUIRE(found == wanted);
        }
    }
}

TEST_CASE("what meets nothing costs as many tests as the tree is deep", "[box_tree]") {
    std::vector<Box> row;
    for (int i = 0; i < 4096; ++i)
        row.push_back({Vec3(i, 0, 0), Vec3(i + 0.5, 1, 1)});
    const BoxTree tree(row);
    for (int i = 1; i < 4096; i += 100) {
        const Vec3 gap(i - 0.25, 0.5, 0.5);
        CHECK(tree.for_each_meeting({gap, gap}, [](std::int32_t) { FAIL(); }) <= 2 * 13);
    }
}
