#include "widgets/models/messages/caseless_finder.h"

#include "core/base/text.h"

namespace usar::widgets {

namespace {

unsigned char byteOf(char c) {
    return static_cast<unsigned char>(lowerCase(c));
}

} // namespace

CaselessFinder::CaselessFinder(std::string_view needle) : needle_(lowerCase(needle)) {
    shift_.fill(needle_.size());
    for (std::size_t i = 0; i + 1 < needle_.size(); ++i)
        shift_[byteOf(needle_[i])] = needle_.size() - 1 - i;
}

std::size_t CaselessFinder::placeIn(std::string_view text) const {
    if (needle_.empty())
        return 0;
    for (std::size_t end = needle_.size() - 1; end < text.size(); end += shift_[byteOf(text[end])]) {
        std::size_t back = 0;
        while (back < needle_.size() && lowerCase(text[end - back]) == needle_[needle_.size() - 1 - back])
            ++back;
        if (back == needle_.size())
            return end + 1 - needle_.size();
    }
    return std::string_view::npos;
}

} // namespace usar::widgets
