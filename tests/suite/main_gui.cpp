// The programs that paint pictures, without widgets.
#include <QGuiApplication>

#include "tests/suite/suite.h"

int main(int argc, char** argv) {
    const QGuiApplication application(argc, argv);
    return usar::test::runTests(argc, argv);
}
