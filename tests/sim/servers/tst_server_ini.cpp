#include <QObject>
#include <QTest>

#include "core/sim/servers/server_ini.h"
#include "tests/suite/suite.h"

namespace tst_server_ini {

using namespace usar::sim;

class tst_ServerIni : public QObject {
    Q_OBJECT
private slots:
    void keepsEveryLine_data() {
        QTest::addColumn<QString>("text");
        QTest::newRow("one section") << "[A]\nx=1\n";
        QTest::newRow("lines before the first") << "; head\n\n[A]\nx=1\n\n[B]\n; nothing\n";
        QTest::newRow("a section twice") << "[A]\nx=1\n[A]\nx=2\n";
        QTest::newRow("nothing") << "";
    }
    void keepsEveryLine() {
        QFETCH(const QString, text);
        QCOMPARE(QString::fromStdString(textOf(sectionsOf(text.toStdString()), "\n")), text);
    }

    void takesAllLineEnds() {
        const auto sections = sectionsOf("[A]\r\nx=1\r\ry=2\n[B]");
        QCOMPARE(sections.size(), std::size_t(3));
        QCOMPARE(sections[1].lines, (std::vector<std::string>{"x=1", "", "y=2"}));
        QCOMPARE(sections[2].name, std::string("B"));
    }

    void readsAnEntry_data() {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("value");
        QTest::newRow("plain") << "MaxRange=20.0"
                               << "MaxRange"
                               << "20.0";
        QTest::newRow("spaces") << "  MaxRange = 20.0 "
                                << "MaxRange"
                                << "20.0";
        QTest::newRow("added") << "+Sensors=(A=1)"
                               << "Sensors"
                               << "(A=1)";
        QTest::newRow("indexed") << "Sensors[3]=(A=1)"
                                 << "Sensors"
                                 << "(A=1)";
        QTest::newRow("comment") << ";Sensors=(A=1)"
                                 << ""
                                 << "";
        QTest::newRow("no entry") << "words"
                                  << ""
                                  << "";
    }
    void readsAnEntry() {
        QFETCH(const QString, line);
        const std::string text = line.toStdString();
        const auto [key, value] = entryOf(text);
        QTEST(QString::fromStdString(std::string(key)), "key");
        QTEST(QString::fromStdString(std::string(value)), "value");
    }

    void readsFieldsInAnyOrderAndCase() {
        const IniFields fields =
            fieldsOf("(ItemClass=class'USARBot.SonarSensor', itemname=\"F,1)\",Direction=(Y=0.5,Z=-1,X=0))");
        QCOMPARE(fields.size(), std::size_t(3));
        QCOMPARE(classIn(fieldIn(fields, "itemclass")), std::string_view("USARBot.SonarSensor"));
        QCOMPARE(fieldIn(fields, "ItemName"), std::string_view("F,1)"));
        QCOMPARE(fieldIn(fieldsOf(fieldIn(fields, "Direction")), "z"), std::string_view("-1"));
        QVERIFY(fieldIn(fields, "Parent").empty());
    }

    void survivesEveryPrefixOfALine() {
        const std::string line = "(ItemClass=class'USARBot.SonarSensor',ItemName=\"F1\",Position=(X=0.1,Y=0,Z=0))";
        for (std::size_t length = 0; length < line.size(); ++length)
            QVERIFY(fieldsOf(std::string_view(line).substr(0, length)).size() <= 3);
        QCOMPARE(fieldsOf(line).size(), std::size_t(3));
    }
};

USAR_TEST(tst_ServerIni)

} // namespace tst_server_ini

#include "tst_server_ini.moc"
