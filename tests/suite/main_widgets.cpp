// The programs that show widgets.
#include <QApplication>

#include "tests/suite/suite.h"

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_Use96Dpi);
    const QApplication application(argc, argv);
    return usar::test::runTests(argc, argv);
}
