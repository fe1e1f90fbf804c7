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
    const auto asks = [](std::string_view argument) { return argument == "--version" || argument == "-v"; };
    if (arguments.empty())
        return false;
    const auto options = arguments.subspan(1);
    const auto options_end =
        std::ranges::find(options, std::string_view("--"), [](const char* word) { return std::string_view(word); });
    if (std::none_of(options.begin(), options_end, asks))
        return false;
    const std::string_view path = arguments.front();
    std::printf("%s %s\n", std::string(path.substr(path.rfind('/') + 1)).c_str(), USAR_VERSION);
    return true;
}

} // namespace usar
