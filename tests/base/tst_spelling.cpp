#include <QTest>

#include "core/base/spelling.h"
#include "tests/suite/suite.h"

namespace tst_spelling {

using namespace usar;

class tst_Spelling : public QObject {
    Q_OBJECT
private slots:
    void countsTheLettersToMend_data() {
        QTest::addColumn<QString>("a");
        QTest::addColumn<QString>("b");
        QTest::addColumn<int>("distance");
        QTest::newRow("nothing") << ""
                                 << "" << 0;
        QTest::newRow("the same") << "lane"
                                  << "lane" << 0;
        QTest::newRow("all put in") << ""
                                    << "lane" << 4;
        QTest::newRow("one put in") << "lne"
                                    << "lane" << 1;
        QTest::newRow("one changed") << "line"
                                     << "lane" << 1;
        QTest::newRow("two swapped") << "widht"
                                     << "width" << 2;
        QTest::newRow("another case") << "Lane"
                                      << "lane" << 1;
    }
    void countsTheLettersToMend() {
        QFETCH(QString, a);
        QFETCH(QString, b);
        QFETCH(int, distance);
        QCOMPARE(editDistance(a.toStdString(), b.toStdString()), static_cast<std::size_t>(distance));
        QCOMPARE(editDistance(b.toStdString(), a.toStdString()), static_cast<std::size_t>(distance));
    }

    void namesTheNearestWord() {
        QCOMPARE(nearestWord("widht", {"x", "height", "width"}), std::string("width"));
        QCOMPARE(nearestWord("c", {"a", "b"}), std::string("a")); // the first of two that are as near
        QCOMPARE(nearestWord("c", {}), std::string());
    }
};

USAR_TEST(tst_Spelling)

} // namespace tst_spelling

#include "tst_spelling.moc"
