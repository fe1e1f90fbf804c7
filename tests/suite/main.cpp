// The programs without pictures: an event loop and nothing else.
#include <QCoreApplication>

#include "tests/suite/suite.h"

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    return usar::test::runTests(argc, argv);
}
