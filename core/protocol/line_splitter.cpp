#include "core/protocol/line_splitter.h"

namespace usar::protocol {

bool LineSplitter::takePiece(std::string_view& bytes, std::string_view& line) {
    // Twice for one byte takes a fraction of the time of once for any of two.
    const std::string_view to_line_feed = bytes.substr(0, bytes.find('\n'));
    const std::string_view piece = to_line_feed.substr(0, to_line_feed.find('\r'));
    const bool ended = piece.size() < bytes.size();
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

void LineSplitter::split(std::string_view bytes, std::vector<std::string_view>& lines) {
    lines.clear();
    std::string_view line;
    while (takePiece(bytes, line)) {
        if (!line.empty() && line.data() == pending_.data()) { // Only the first one can be.
            joined_.swap(pending_);
            line = joined_;
        }
        if (!line.empty())
            lines.push_back(line);
        pending_.clear();
    }
}

void LineSplitter::reset() {
    pending_.clear();
    dropping_ = false;
}

} // namespace usar::protocol
