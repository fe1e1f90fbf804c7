#include "core/base/version.h"

#include <algorithm>
#include <cstdio>
#include <span>
#include <string>

namespace usar {

std::string_view version() {
    return USAR_VERSION;
}

bool answersVersion(int argc, const char* const* argv) {
    const std::span arguments(argv, static_cast<std::size_t>(argc));
    if (arguments.empty() || std::ranges::count(arguments, std::string_view("--version")) == 0)
        return false;
    const std::string_view path = arguments.front();
    std::printf("%s %s\n", std::string(path.substr(path.rfind('/') + 1)).c_str(), USAR_VERSION);
    return true;
}

} // namespace usar
