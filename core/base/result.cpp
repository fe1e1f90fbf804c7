#include "core/base/result.h"

#include <utility>

namespace usar {

std::string Error::text() const {
    std::string sentence = where.empty() ? what : where + ": " + what;
    if (!sentence.empty() && sentence.back() != '.')
        sentence += '.';
    if (!mend.empty())
        sentence += " " + mend + (mend.back() == '.' || mend.back() == '?' ? "" : ".");
    return sentence;
}

tl::unexpected<Error> failure(std::string what, std::string where, std::string mend) {
    return tl::unexpected<Error>(Error{std::move(what), std::move(where), std::move(mend)});
}

} // namespace usar
