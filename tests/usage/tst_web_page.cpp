#include <QObject>
#include <QTest>

#include "core/usage/web_page.h"
#include "tests/suite/suite.h"

namespace tst_web_page {

using namespace usar::usage;

class tst_WebPage : public QObject {
    Q_OBJECT
private slots:
    void makesAnchorsAsGitHubDoes_data() {
        QTest::addColumn<QString>("heading");
        QTest::addColumn<QString>("anchor");
        QTest::newRow("words") << "Driving by hand"
                               << "driving-by-hand";
        QTest::newRow("an option") << "What the simulator does with --profile udk"
                                   << "what-the-simulator-does-with---profile-udk";
        QTest::newRow("a number and signs") << "6.2 WSS (50000): wireless, too"
                                            << "62-wss-50000-wireless-too";
        QTest::newRow("letters of any language") << "Ærø über"
                                                 << "ærø-über";
    }
    void makesAnchorsAsGitHubDoes() {
        QFETCH(const QString, heading);
        QTEST(anchorOf(heading), "anchor");
    }

    void leadsLinksToThePagesThatWereMade_data() {
        QTest::addColumn<QString>("body");
        QTest::addColumn<QString>("made");
        QTest::newRow("a page") << "<a href=\"udk.md\">x</a>"
                                << "<a href=\"udk.html\">x</a>";
        QTest::newRow("a place in a page") << "<a href=\"../a.md#b-c\">x</a>"
                                           << "<a href=\"../a.html#b-c\">x</a>";
        QTest::newRow("a place in this page") << "<a href=\"#b\">x</a>"
                                              << "<a href=\"#b\">x</a>";
        QTest::newRow("the web") << "<a href=\"https://x.org/a.md\">x</a>"
                                 << "<a href=\"https://x.org/a.md\">x</a>";
        QTest::newRow("a picture") << "<img src=\"a.png\" />"
                                   << "<img src=\"a.png\" />";
        QTest::newRow("a heading") << "<h2>What <code>a &amp; b</code> is</h2>"
                                   << "<h2 id=\"what-a--b-is\">What <code>a &amp; b</code> is</h2>";
        QTest::newRow("headings alike") << "<h2>A</h2><h3>A</h3><h3>A</h3>"
                                        << "<h2 id=\"a\">A</h2><h3 id=\"a-1\">A</h3><h3 id=\"a-2\">A</h3>";
    }
    void leadsLinksToThePagesThatWereMade() {
        QFETCH(const QString, body);
        QFETCH(const QString, made);
        const QString page = webPage(body, "../");
        QVERIFY2(page.contains("<main>\n" + made + "</main>"), qPrintable(page));
    }

    void namesThePageAfterItsFirstHeading() {
        const QString page = webPage("<h1>A <code>&lt;b&gt;</code></h1><h2>C</h2>", "../../");
        QVERIFY2(page.contains("<title>A &lt;b&gt;</title>"), qPrintable(page));
        QVERIFY(page.contains("href=\"../../page.css\"") && page.contains("href=\"../../README.html\""));
    }
};

USAR_TEST(tst_WebPage)

} // namespace tst_web_page

#include "tst_web_page.moc"
