// A desktop of the tests' own, as a person has one: a screen with a window manager, a mouse, a keyboard, and the bus on
// which programs tell a screen reader about their widgets.
#pragma once

#include <memory>
#include <vector>

#include <QDBusConnection>
#include <QImage>
#include <QPoint>
#include <QProcess>
#include <QSize>
#include <QTemporaryDir>

namespace usar::hands {

/// Makes the process end with this one, even if this one is killed. Before it is started.
void endWithUs(QProcess& process);

/// Xvfb, openbox, a session bus and the accessibility bus, all ended with this object. Events come from the X server
/// itself (XTest), so they pass the window manager, focus, grabs, and Qt's own input handling.
class Desktop {
public:
    explicit Desktop(const QSize& size_px = {1280, 800});
    ~Desktop();
    Q_DISABLE_COPY_MOVE(Desktop)

    /// Empty if everything runs; otherwise a sentence that says what does not.
    const QString& trouble() const { return trouble_; }
    /// For a program on this desktop.
    const QProcessEnvironment& environment() const { return environment_; }
    QDBusConnection accessibility() const;
    const QSize& size() const { return size_px_; }

    void click(const QPoint& at, int button = 1);
    void doubleClick(const QPoint& at);
    /// Presses at `from`, moves in steps, as a hand does, and releases at `to`.
    void drag(const QPoint& from, const QPoint& to);
    void moveTo(const QPoint& at);
    /// Presses and releases a key or a chord by its X name: "Return", "ctrl+period".
    void key(const QString& chord);
    /// Holds a key down until `letGo`; it repeats, as held keys do.
    void press(const QString& key);
    void letGo(const QString& key);
    /// Presses and releases a key twice, as fast as a person in a hurry.
    void keyTwice(const QString& chord);
    void type(const QString& text);

    /// The screen as it is; null if it cannot be read.
    QImage screenshot() const;
    /// Ids of the windows whose title contains these words.
    QStringList windows(const QString& title) const;
    /// Asks the window manager for another size of the window.
    void resize(const QString& window, const QSize& size_px);

private:
    /// Starts a program that runs as long as this object; nullptr, and `trouble_` set, where it does not start.
    QProcess* start(const QString& program, const QStringList& arguments);
    QString firstLine(QProcess* process);
    void xdotool(const QStringList& arguments) const;

    QSize size_px_;
    QTemporaryDir folder_;
    QString trouble_;
    QProcessEnvironment environment_;
    std::vector<std::unique_ptr<QProcess>> running_;
    QString bus_name_;
};

} // namespace usar::hands
