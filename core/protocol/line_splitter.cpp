#include "core/protocol/line_splitter.h"

#include <algorithm>

namespace usar::protocol {

bool LineSplitter::takePiece(std::string_view& bytes, std::string_view& line) {
    const auto end = std::find_if(bytes.begin(), bytes.end(), [](char c) { return c == '\r' || c == '\n'; });
    const bool ended = end != bytes.end();
    const std::string_view piece = bytes.substr(0, static_cast<std::size_t>(end - bytes.begin()));
    bytes.remove_prefix(piece.size() + (ended ? 1 : 0));

    if (!dropping_ && pending_.size() + piece.size() > cap_bytes_) {
        dropping_ = true;
        ++overlong_count_;
        std::string().swap(pending_);
    }
    if (dropping_) {
        dropping_ = !ended;
        line = {};
    } else if (ended && pending_.empty()) {
        line = piece;
    } else {
        pending_.append(piece);
        line = pending_;
    }
    return ended;
}

void LineSplitter::reset() {
    pending_.clear();
    dropping_ = false;
}

} // namespace usar::protocol
