#include "tests/suite/suite.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <QTest>

namespace usar::test {

namespace {

using Tests = std::map<std::string, MakeTest, std::less<>>;

/// Made on the first use, which is before main and in no known order.
Tests& tests() {
    static Tests all;
    return all;
}

void print(std::FILE* file, const char* indent) {
    for (const auto& [name, make] : tests())
        std::fprintf(file, "%s%s\n", indent, name.c_str());
}

int run(MakeTest make, std::vector<char*> arguments) {
    const std::unique_ptr<QObject> test = make();
    arguments.push_back(nullptr);
    return QTest::qExec(test.get(), static_cast<int>(arguments.size()) - 1, arguments.data());
}

} // namespace

bool addTest(const char* source_file, MakeTest make) {
    return tests().emplace(std::filesystem::path(source_file).stem().string(), make).second;
}

int runTests(int argc, char** argv) {
    std::vector<char*> arguments(argv, argv + argc);
    const std::string_view first = argc > 1 ? argv[1] : "";
    if (first == "--list") {
        print(stdout, "");
        return 0;
    }
    if (first.starts_with("tst_")) {
        const auto found = tests().find(first);
        if (found == tests().end()) {
            std::fprintf(stderr, "%s has no test %s. It has:\n", argv[0], argv[1]);
            print(stderr, "  ");
            return 127;
        }
        arguments.erase(arguments.begin() + 1);
        return run(found->second, arguments);
    }
    const auto failed =
        std::ranges::count_if(tests(), [&](const auto& test) { return run(test.second, arguments) != 0; });
    return static_cast<int>(std::min<std::ptrdiff_t>(failed, 100));
}

} // namespace usar::test
