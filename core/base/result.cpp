#include "core/base/result.h"

#include <utility>

namespace usar {

namespace {

std::string withCapital(std::string sentence) {
    if (!sentence.empty() && sentence.front() >= 'a' && sentence.front() <= 'z')
        sentence.front() = static_cast<char>(sentence.front() - 'a' + 'A');
    return sentence;
}

} // namespace

std::string Error::text() const {
    std::string sentence = where.empty() ? withCapital(what) : where + ": " + what;
    if (!sentence.empty() && sentence.back() != '.')
        sentence += '.';
    if (!mend.empty())
        sentence += " " + withCapital(mend) + (mend.back() == '.' || mend.back() == '?' ? "" : ".");
    return sentence;
}

tl::unexpected<Error> failure(std::string what, std::string where, std::string mend) {
    return tl::unexpected<Error>(Error{std::move(what), std::move(where), std::move(mend)});
}

} // namespace usar
