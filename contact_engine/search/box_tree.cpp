#include "box_tree.h"

#include <algorithm>
#include <tuple>

namespace braidx {

BoxTree::BoxTree(const std::vector<Box>& boxes) {
    std::vector<Item> items;
    for (const auto& box : boxes)
        items.push_back({box, static_cast<std::int32_t>(items.size())});
    nodes_.reserve(2 * items.size());
    if (!items.empty())
        build(items, 0, items.size());
}

void BoxTree::build(std::vector<Item>& items, std::size_t begin, std::size_t end) {
    Box box = items[begin].box;
    for (std::size_t i = begin + 1; i < end; ++i)
        box = box.joined(items[i].box);
    const auto at = nodes_.size();
    nodes_.push_back({box, 0, items[begin].number});
    if (end - begin == 1)
        return;
    Eigen::Index axis;
    (box.high - box.low).maxCoeff(&axis);
    const auto middle = begin + (end - begin) / 2;
    const auto iterator = [&](std::size_t i) {
        return items.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::ranges::nth_element(
        iterator(begin), iterator(middle), iterator(end), {}, [axis](const Item& item) {
            const double centre = 0.5 * item.box.low[axis] + 0.5 * item.box.high[axis];
            return std::pair(centre, item.number);
        });
    build(items, begin, middle);
    nodes_[at].second = nodes_.size();
    build(items, middle, end);
}

} // namespace braidx
