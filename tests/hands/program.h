// Mission Control as a process of its own on a desktop of its own, and a person before it.
#pragma once

#include "tests/hands/desktop.h"
#include "tests/hands/screen_reader.h"

namespace usar::hands {

/// Starts the program with the embedded simulator on free ports, with the settings of a first start. A person reads by
/// `read` and acts by `desk`; nothing here reaches into the program. The environment variable USAR_PROGRAM names
/// another build of it, such as one that still has a defect; what finds things here works with those, too.
class Program {
public:
    explicit Program(const QSize& screen_px = {1280, 800}, const QStringList& arguments = {});
    ~Program();
    Q_DISABLE_COPY_MOVE(Program)

    /// Empty while program and desktop run and a window of the program took keys; otherwise a sentence that says what
    /// does not.
    QString trouble() const;
    Desktop& desk() { return desktop_; }
    const ScreenReader& read() const { return *reader_; }
    const QString& resultFolder() const { return results_; }

    /// Clicks the middle of the first widget with this role and name, once it is enabled and stands still; false, after
    /// a while, where there is none.
    bool click(const QString& role, const QString& name);
    /// The same for a button.
    bool press(const QString& name) { return click("push button", name); }
    /// Presses Tab until a widget with this role has the focus; false if none gets it.
    bool tabTo(const QString& role);
    /// True once a widget on the screen has these words as its name or description, or as a part of them.
    bool says(const QString& words, int within_ms = 30000) const;
    /// Description of the instrument with this name: its figure with the unit. Empty where there is none.
    QString figure(const QString& name) const;
    /// The number at the beginning of that; 0 where there is none.
    double number(const QString& name) const { return figure(name).section(' ', 0, 0).toDouble(); }
    /// What the list of robots says about this one: "R1, AirRobot, taking off, …". Empty where it is not listed.
    QString row(const QString& robot) const;

    /// Gives the map the keys, which shows the whole world then.
    bool lookAtWorld();
    /// Double-clicks the start pose with this name and waits for the robot's row; false where either is missing.
    bool spawnAt(const QString& start_pose, const QString& robot);
    /// The same by keys on the map.
    bool spawnByKeys(const QString& start_pose, const QString& robot);
    /// Draws a mission area in the middle of the world, presses Start, and waits until the robot flies.
    bool fly();
    /// Saves what is on the screen as build/PRESET/screenshots/hands_NAME.png.
    void screenshot(const QString& name) const;
    /// The program's end: its exit code, or nullopt if it does not end within the time.
    std::optional<int> ended(int within_ms);

private:
    /// The first widget that is wanted, once it was seen twice at the same place: docks open and views are fitted while
    /// a hand already aims.
    std::optional<Seen> settled(const ScreenReader::Wanted& wanted) const;
    /// Presses the key and waits until what `look` reads has changed, so that no later key overtakes it; false if it
    /// stays as it was.
    bool keyChanges(const QString& key, const std::function<QString()>& look);
    bool takesMark(const QString& start_pose);

    Desktop desktop_;
    QTemporaryDir folder_;
    QString results_;
    QProcess process_;
    std::optional<ScreenReader> reader_;
    bool has_keyboard_ = false;
};

} // namespace usar::hands
