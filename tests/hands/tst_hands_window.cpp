// The window itself under keys and mouse: tools, palette, themes, files, and screens of two sizes.
#include <QTest>

#include "tests/hands/program.h"
#include "tests/suite/suite.h"

namespace tst_hands_window {

using namespace usar::hands;

namespace {

constexpr int patience_ms = 30000;

/// Mean brightness of the screen, 0 to 255.
int brightness(const Desktop& desktop) {
    const QImage small = desktop.screenshot().scaled(64, 64, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    int sum = 0;
    for (int y = 0; y < small.height(); ++y)
        for (int x = 0; x < small.width(); ++x)
            sum += qGray(small.pixel(x, y));
    return small.isNull() ? 0 : sum / (small.width() * small.height());
}

} // namespace

class tst_HandsWindow : public QObject {
    Q_OBJECT
private slots:
    void init();
    void escapeLeavesTheAreaTool();
    void thePaletteRaisesADockBehindATab();
    void thePaletteKnowsOtherWords();
    void themesChangeTheWholeWindow();
    void aMissionIsOpenedByItsPath();
    void theWindowFitsTheScreen_data();
    void theWindowFitsTheScreen();

private:
    bool drawing() const { return program_->read().find(drawButton, 0).value_or(Seen{}).checked(); }
    static bool drawButton(const Seen& seen) { return seen.role == "check box" && seen.name.startsWith("Draw"); }
    /// Where the widget is that looks like the robot's camera; behind its tab it is nowhere.
    bool cameraIsSeen() const {
        return program_->read().find([](const Seen& seen) { return seen.name == "Camera picture"; }, 0).has_value();
    }
    void runByPalette(const QString& words);

    std::optional<Program> program_;
};

void tst_HandsWindow::init() {
    if (program_)
        return;
    program_.emplace();
    QVERIFY2(program_->trouble().isEmpty(), qPrintable(program_->trouble()));
    QVERIFY(program_->says("Connected"));
}

/// The palette is no part of the tree that a screen reader sees, so what counts is what it did.
void tst_HandsWindow::runByPalette(const QString& words) {
    program_->desk().key("ctrl+k");
    program_->desk().type(words);
    program_->screenshot("palette_" + words);
    program_->desk().key("Return");
}

void tst_HandsWindow::escapeLeavesTheAreaTool() {
    QVERIFY(program_->lookAtWorld());
    program_->desk().key("a");
    QTRY_VERIFY_WITH_TIMEOUT(drawing(), patience_ms);
    program_->desk().key("Escape");
    QTRY_VERIFY_WITH_TIMEOUT(!drawing(), patience_ms);
}

void tst_HandsWindow::thePaletteRaisesADockBehindATab() {
    QVERIFY(!cameraIsSeen());
    runByPalette("Camera");
    QTRY_VERIFY_WITH_TIMEOUT(cameraIsSeen(), patience_ms);
}

void tst_HandsWindow::thePaletteKnowsOtherWords() {
    const auto speed = [this](const QString& text) {
        return program_->read().find("combo box", text, patience_ms).has_value();
    };
    QVERIFY(speed(QStringLiteral("1×")));
    runByPalette("turbo");
    QVERIFY(speed("max"));
    runByPalette("normal speed");
    QVERIFY(speed(QStringLiteral("1×")));
}

void tst_HandsWindow::themesChangeTheWholeWindow() {
    constexpr int dark = 90;
    constexpr int light = 150;
    QTRY_VERIFY_WITH_TIMEOUT(brightness(program_->desk()) < dark, patience_ms);
    program_->desk().key("ctrl+t");
    QTRY_VERIFY_WITH_TIMEOUT(brightness(program_->desk()) > light, patience_ms);
    program_->screenshot("light");
    program_->desk().key("ctrl+t");
    QTRY_VERIFY_WITH_TIMEOUT(brightness(program_->desk()) < dark, patience_ms);
}

void tst_HandsWindow::aMissionIsOpenedByItsPath() {
    program_->desk().key("ctrl+o");
    QTRY_VERIFY_WITH_TIMEOUT(!program_->desk().windows("Open mission").isEmpty(), patience_ms);
    const auto field = program_->read().find([](const Seen& seen) { return seen.role == "text" && seen.focused(); });
    QVERIFY(field);
    const QString path = USAR_SOURCE_DIR "/resources/missions/quick_scan.json";
    program_->desk().type(path);
    QTRY_COMPARE_WITH_TIMEOUT(program_->read().textOf(*field), path, patience_ms);
    program_->desk().key("Return");
    QVERIFY(program_->says("5 lanes"));
    QVERIFY(program_->desk().windows("Open mission").isEmpty());
}

void tst_HandsWindow::theWindowFitsTheScreen_data() {
    QTest::addColumn<QSize>("size_px");
    QTest::newRow("small") << QSize(1024, 768);
    QTest::newRow("large") << QSize(1920, 1080);
}

void tst_HandsWindow::theWindowFitsTheScreen() {
    QFETCH(QSize, size_px);
    program_.emplace(size_px);
    QVERIFY2(program_->trouble().isEmpty(), qPrintable(program_->trouble()));
    QVERIFY(program_->says("Connected"));
    const auto frame = [this] { return program_->read().find("frame", "Mission Control").value_or(Seen{}).at; };
    const auto maximized = [&] { return frame().width() > size_px.width() - 20; };
    for (int i = 0; i < 5; ++i) { // On a busy machine the window manager may take it for two clicks.
        program_->desk().doubleClick(QPoint(frame().center().x(), frame().top() - 8)); // On the title bar.
        if (QTest::qWaitFor(maximized, patience_ms / 5))
            break;
    }
    QVERIFY(maximized());
    for (const QString& dock : QStringList{"", "Layers", "Plan", "World"}) {
        if (!dock.isEmpty())
            runByPalette("Show " + dock);
        QTRY_VERIFY2_WITH_TIMEOUT(QRect(QPoint(), size_px).contains(frame()), qPrintable(dock), patience_ms);
        for (const QString& button : QStringList{"Stop all robots", "Start"}) {
            if (button == "Start" && dock == "World")
                continue; // It is behind that.
            const auto seen = program_->read().find("push button", button);
            QVERIFY2(seen, qPrintable(button + " beside " + dock));
            QVERIFY2(frame().contains(seen->at), qPrintable(button + " beside " + dock));
        }
    }
    program_->screenshot("screen_" + QString(QTest::currentDataTag()));
}

USAR_TEST(tst_HandsWindow)

} // namespace tst_hands_window

#include "tst_hands_window.moc"
