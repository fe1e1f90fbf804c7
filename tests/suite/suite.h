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

/// Runs tests and returns the exit code of the program. The first argument may name a test; Qt Test takes the rest,
/// which are names of functions and its own options. Without a name all tests run one after the other, and the code is
/// the number of failed ones, at most 100. `--list` prints the names, one on each line. The code is 127 where no test
/// has the name that was given; the message then lists all tests.
int runTests(int argc, char** argv);

} // namespace usar::test

/// Makes a class of test functions known; stands once in each tst_NAME.cpp.
#define USAR_TEST(TestClass)                                                                                           \
    [[maybe_unused]] static const bool TestClass##_is_added =                                                          \
        usar::test::addTest(__FILE__, [] { return std::unique_ptr<QObject>(std::make_unique<TestClass>()); });
