#include <QTest>

#include "core/campaign/plan/shell_word.h"
#include "core/campaign/plan/shell_words.h"
#include "tests/suite/suite.h"

namespace tst_shell_words {

using namespace usar::campaign;

/// Commands of result lines are read as a shell reads them.
class tst_ShellWords : public QObject {
    Q_OBJECT
private slots:
    void wordsAreThoseOfAShell_data() {
        QTest::addColumn<QString>("command");
        QTest::addColumn<QStringList>("words");
        QTest::newRow("nothing") << "" << QStringList();
        QTest::newRow("plain") << "usar-mission  run a.json " << QStringList{"usar-mission", "run", "a.json"};
        QTest::newRow("in quotes") << "--fault 'wind speed=5 from=3'" << QStringList{"--fault", "wind speed=5 from=3"};
        QTest::newRow("an apostrophe") << "'it'\\''s here'" << QStringList{"it's here"};
        QTest::newRow("an empty word") << "--plan '' x" << QStringList{"--plan", "", "x"};
        QTest::newRow("double quotes") << "\"a \\\"b\\\" 'c'\"" << QStringList{"a \"b\" 'c'"};
        QTest::newRow("a backslash within quotes") << "'a\\b'" << QStringList{"a\\b"};
        QTest::newRow("parts of one word") << "/home/'my files'/a\\ b" << QStringList{"/home/my files/a b"};
    }

    void wordsAreThoseOfAShell() {
        QFETCH(QString, command);
        QFETCH(QStringList, words);
        const auto read = shellWords(command);
        QVERIFY(read);
        QCOMPARE(*read, words);
    }

    void whatIsQuotedIsReadBack() {
        const QStringList words{"run", "/a b/c's.json", "--set", "parameters.x=3", "", "ä\"\\"};
        QStringList quoted;
        for (const QString& word : words)
            quoted << shellWord(word);
        QCOMPARE(shellWords(quoted.join(' ')).value(), words);
    }

    void aQuoteWithoutItsEndIsRefused() {
        const auto read = shellWords("run 'a.json");
        QVERIFY(!read);
        QVERIFY(read.error().text().find("a quote has no end") != std::string::npos);
    }
};

USAR_TEST(tst_ShellWords)

} // namespace tst_shell_words

#include "tst_shell_words.moc"
