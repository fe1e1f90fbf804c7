// Keeps the newest line of every stream until somebody has time to look.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/info_message.h"

namespace usar::widgets {

/// What tells streams of one connection apart: "SEN Sonar F1", "STA", "GEO RangeScanner".
std::string streamOf(const protocol::InfoMessage& message);

/// A line and how many of its stream came since the last look, this one included.
struct CountedLine {
    protocol::InfoLine line;
    Seconds now{0.0};
    int count = 0;
};

/// Bounds the work of a slow or hidden view: a thousand lines of one stream cost as much as one. Nothing that was sent
/// only once is lost. A value; one owner.
class NewestLines {
public:
    void take(const protocol::InfoLine& line, Seconds now);
    /// In the order in which the streams first spoke since the last call.
    std::vector<CountedLine> takeAll();

private:
    std::map<std::string, std::size_t> places_;
    std::vector<CountedLine> lines_;
};

} // namespace usar::widgets
