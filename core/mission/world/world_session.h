// A world controller's connection to any USARSim server: puts things into the world and knows where they are.
#pragma once

#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "core/link/tcp_link.h"
#include "core/mission/session/session_update.h"
#include "core/protocol/info/world_objects.h"
#include "core/protocol/reader.h"

namespace usar::mission {

/// A thing in the world, as the server last reported it.
struct WorldThing {
    std::string name;
    std::string class_name;     ///< without package; empty if it is unknown
    std::optional<Vec3> size_m; ///< along its own axes; absent: unknown
    Pose body_in_map;
    Vec3 velocity_in_map_m_s = Vec3::Zero(); ///< per wall time, over the last second
    bool operator==(const WorldThing&) const = default;
};

/// Asking: connected, but the server has not answered yet. Refused: it does not answer as a world controller.
enum class WorldState { Off, Connecting, Asking, Ready, Refused };

/// State of the connection, and the known things.
struct WorldView {
    WorldState state = WorldState::Off;
    std::string trouble; ///< a sentence with the remedy; empty while all is well
    std::vector<WorldThing> things;
    bool operator==(const WorldView&) const = default;
};

/// Limits in wall time. Tests shorten them.
struct WorldSessionLimits {
    link::LinkLimits link;
    std::chrono::milliseconds answer{4000}; ///< longest time that a question may stay open
    std::chrono::milliseconds settle{250};  ///< between questions after a command
    int settling_questions = 4;             ///< questions after a command, even without polling
};

/// Runs in a thread of its own, as a RobotSession does; slots are called by queued connection, values leave in signals.
/// A server answers nothing but GetSTA: an unknown class shows only in a thing that never appears, which is then
/// reported. One question is open at a time. INIT is sent with UT2004's class name first, and with UDK's on a second
/// connection. Things that it created may disappear with a lost connection, depending on the server's configuration.
class WorldSession : public QObject {
    Q_OBJECT
public:
    WorldSession();

    /// To be called before `open`.
    void setLimits(const WorldSessionLimits& limits);
    const WorldView& view() const { return view_; }

public slots:
    /// Forgets what another server answered, and connects; reconnects after a loss until `close`.
    void open(const QString& host, quint16 port);
    /// Ends the connection; the state becomes Off and the list of things empty.
    void close();
    /// Classes that are asked for to find out the kinds of things that others created.
    void setClasses(const std::vector<std::string>& class_names) { classes_ = class_names; }
    /// How often to ask where things are; nullopt: only after commands.
    void setPolling(std::optional<std::chrono::milliseconds> interval);
    /// While the simulator is paused it answers nothing, and that is not reported.
    void setPaused(bool paused);
    /// Sends one of the commands of world_control.h. While the first attempt to connect is under way it waits, and goes
    /// out when the server is there; without a connection it is only reported.
    void send(const usar::protocol::Command& command);
    /// The embedded simulator refused to create this object of ours; `reason` is part of a sentence.
    void refuse(const QString& name, const QString& reason);

signals:
    /// Emitted after every answer and every change of the state; each view is a copy that never changes.
    void changed(std::shared_ptr<const usar::mission::WorldView> view);
    /// The topic is "world", or "world/placing" for a thing that did not appear.
    void noticed(const usar::mission::Notice& notice);

private:
    struct Question {
        std::string class_name; ///< class that is asked about; empty: all things
        QElapsedTimer since;
    };
    /// A thing that was created by a command and has not been seen yet.
    struct Awaited {
        std::string class_name;
        int answers = 0; ///< answers without it so far
    };
    struct Sample {
        qint64 at_ms = 0;
        Vec3 position_m = Vec3::Zero();
    };

    /// Sends INIT and the first question.
    void opened();
    /// Forgets things, open questions and expected things.
    void closed();
    /// Ignores all lines but WorldObjects, and takes these for the answer to the open question.
    void takeLine(std::string_view line);
    /// Replaces the list of things by the answer to a question about all of them.
    void takeThings(const protocol::WorldObjects& objects);
    /// Asks for each of our classes as soon as a thing of unknown origin appears.
    void learnKinds();
    /// Reports a created thing that is missing from three answers in a row.
    void noteAwaited();
    void failToPlace(std::string sentence);
    /// Reports that a command was not sent.
    void refuseWithoutConnection();
    /// Map frame, m/s; zero until positions from more than 0.05 s are known.
    Vec3 velocityOf(const std::string& name, const Vec3& position_m);
    void beat();
    void ask();
    /// A first unanswered question leads to a second connection with UDK's class name, later ones to a warning.
    void missAnswer();
    void setState(WorldState state, std::string trouble = {});
    /// Emits `changed` with a copy of the view.
    void tell() { emit changed(std::make_shared<const WorldView>(view_)); }

    link::TcpLink link_;
    QTimer beat_;
    QElapsedTimer clock_;
    QElapsedTimer since_asked_;
    WorldSessionLimits limits_;
    protocol::Reader reader_;
    WorldView view_;
    /// Commands given while the connection was being made.
    std::vector<protocol::Command> waiting_;
    std::optional<std::chrono::milliseconds> polling_;
    /// Questions still to be asked without polling.
    int questions_left_ = 0;
    bool paused_ = false;
    bool ever_answered_ = false; ///< by this server
    /// A warning about missing answers has been given and not been taken back.
    bool silence_said_ = false;
    bool placing_failed_ = false;                           ///< reported, and nothing has appeared since
    protocol::Dialect dialect_ = protocol::Dialect::Ut2004; ///< dialect in which INIT is sent
    std::optional<Question> open_question_;
    std::deque<std::string> classes_to_ask_;
    std::vector<std::string> classes_;
    std::map<std::string, std::string> kinds_;       ///< class by name; empty: asked for, but none of ours
    std::map<std::string, Awaited> awaited_;         ///< by name
    std::map<std::string, std::deque<Sample>> ways_; ///< positions over the last second, by name
};

} // namespace usar::mission
