// The test classes of one program. All classes of a folder are linked into one program, and each stays an entry of
// ctest of its own: a crash costs one entry, and entries run beside each other.
#pragma once

#include <memory>

#include <QObject>

namespace usar::test {

using MakeTest = std::unique_ptr<QObject> (*)();

/// Adds a class to this program. Its name is the stem of `source_file`: "tst_reader" for tests/protocol/tst_reader.cpp.
/// Called before main by USAR_TEST.
bool addTest(const char* source_file, MakeTest make);

/// Runs tests and returns what main returns. The first argument may name a test; the rest goes to Qt Test, which takes
/// names of functions and its own options. Without a name all tests run one after the other, and the result is how many
/// of them failed, at most 100. `--list` prints the names, a line each. 127: there is no test of that name, and the
/// message lists those that there are.
int runTests(int argc, char** argv);

} // namespace usar::test

/// Makes a class of test functions known; stands once in each tst_NAME.cpp.
#define USAR_TEST(TestClass)                                                                                           \
    [[maybe_unused]] static const bool TestClass##_is_added =                                                          \
        usar::test::addTest(__FILE__, [] { return std::unique_ptr<QObject>(std::make_unique<TestClass>()); });
