#include "core/server/com_frames.h"

#include <algorithm>

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace usar::server {

namespace {

constexpr std::size_t word_bytes = 5; // Length of "SEND " and of "CLOSE".
constexpr std::size_t most_digits = 9;

} // namespace

bool ComFrames::feed(std::string_view bytes, const Take& take) {
    while (!bytes.empty() && state_ != State::Closed) {
        if (state_ != State::Payload) {
            takeOne(bytes.front());
            bytes.remove_prefix(1);
            continue;
        }
        const std::size_t count = std::min(left_, bytes.size());
        take(bytes.substr(0, count));
        bytes.remove_prefix(count);
        left_ -= count;
        if (left_ == 0)
            state_ = State::End;
    }
    return state_ != State::Closed;
}

void ComFrames::takeOne(char c) {
    switch (state_) {
    case State::Between:
        if (isSpace(c) || c == ';')
            return;
        word_.clear();
        state_ = State::Word;
        [[fallthrough]];
    case State::Word:
        word_ += c;
        if (c == ';') // Too short for any word.
            state_ = State::Between;
        else if (word_ == "SEND ")
            state_ = State::Length;
        else if (word_.size() == word_bytes)
            state_ = State::Skip;
        if (state_ == State::Length)
            word_.clear();
        return;
    case State::Length:
        if (c == ' ' && !word_.empty()) {
            left_ = static_cast<std::size_t>(readInteger(word_).value_or(0));
            state_ = left_ > 0 ? State::Payload : State::End;
        } else if (c < '0' || c > '9' || word_.size() == most_digits) {
            word_.clear();
            state_ = c == ';' ? State::Between : State::Skip;
        } else {
            word_ += c;
        }
        return;
    case State::Skip:
        if (c == ';')
            state_ = word_ == "CLOSE" ? State::Closed : State::Between;
        return;
    case State::End:
        state_ = State::Between;
        return;
    case State::Payload:
    case State::Closed:
        return;
    }
}

} // namespace usar::server
