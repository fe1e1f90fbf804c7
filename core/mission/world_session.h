// A world controller's connection to any USARSim server: puts things into the world and knows where they are.
#pragma once

#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "core/link/tcp_link.h"
#include "core/mission/session_update.h"
#include "core/protocol/info/world_objects.h"
#include "core/protocol/reader.h"

namespace usar::mission {

/// A thing as the server told it last.
struct WorldThing {
    std::string name;
    std::string class_name;     ///< without package; empty where it is not known
    std::optional<Vec3> size_m; ///< along its own axes
    Pose body_in_map;
    Vec3 velocity_in_map_m_s = Vec3::Zero(); ///< by wall time, over the last second
    bool operator==(const WorldThing&) const = default;
};

/// Asking: connected, and the server has not answered yet. Refused: it does not answer as a world controller.
enum class WorldState { Off, Connecting, Asking, Ready, Refused };

struct WorldView {
    WorldState state = WorldState::Off;
    std::string trouble; ///< a sentence with the mend; empty while all is well
    std::vector<WorldThing> things;
    bool operator==(const WorldView&) const = default;
};

/// Wall time. Tests shorten them.
struct WorldSessionLimits {
    link::LinkLimits link;
    std::chrono::milliseconds answer{4000}; ///< so long a question may stay open
    std::chrono::milliseconds settle{250};  ///< between questions after a command
    int settling_questions = 4;             ///< after a command, though nobody polls
};

/// Lives in a thread of its own, as a RobotSession does; slots are called by queued connection, values leave in
/// signals. A server answers nothing but GetSTA: that a class is unknown shows in a thing that never comes, and is said
/// so. One question is open at a time. INIT is said with UT2004's class name first and UDK's on a second connection.
/// Things that it made may leave the world with a lost connection, as the server is configured.
class WorldSession : public QObject {
    Q_OBJECT
public:
    explicit WorldSession(QObject* parent = nullptr);
    ~WorldSession() override;

    /// Before `open`.
    void setLimits(const WorldSessionLimits& limits);
    const WorldView& view() const { return view_; }

public slots:
    void open(const QString& host, quint16 port);
    void close();
    /// The classes that are asked for to learn what kinds things are that others made.
    void setClasses(const std::vector<std::string>& class_names);
    /// How often to ask where things are; nothing: only after commands.
    void setPolling(std::optional<std::chrono::milliseconds> interval);
    /// While the simulator stands still it answers nothing, and nothing is wrong.
    void setPaused(bool paused);
    /// One of world_control.h.
    void send(const usar::protocol::Command& command);

signals:
    void changed(std::shared_ptr<const usar::mission::WorldView> view);
    void noticed(const usar::mission::Notice& notice);

private:
    struct Question {
        std::string class_name; ///< empty: all things
        QElapsedTimer since;
    };
    /// A thing that was asked for and has not been seen.
    struct Awaited {
        std::string class_name;
        int answers = 0;
    };
    struct Sample {
        qint64 at_ms = 0;
        Vec3 position_m = Vec3::Zero();
    };

    void opened();
    void closed();
    void takeLine(std::string_view line);
    void takeThings(const protocol::WorldObjects& objects);
    void learnKinds();
    void noteAwaited();
    Vec3 velocityOf(const std::string& name, const Vec3& position_m);
    void beat();
    void ask();
    void missAnswer();
    void setState(WorldState state, std::string trouble = {});
    void tell();

    link::TcpLink link_;
    QTimer beat_;
    QElapsedTimer clock_;
    QElapsedTimer since_asked_;
    WorldSessionLimits limits_;
    protocol::Reader reader_;
    WorldView view_;
    std::optional<std::chrono::milliseconds> polling_;
    int questions_left_ = 0;
    bool paused_ = false;
    bool ever_answered_ = false; ///< on this server
    bool silence_said_ = false;
    protocol::Dialect dialect_ = protocol::Dialect::Ut2004; ///< of the INIT
    std::optional<Question> open_question_;
    std::deque<std::string> classes_to_ask_;
    std::vector<std::string> classes_;
    std::map<std::string, std::string> kinds_; ///< by name; empty: asked for, and none of ours
    std::map<std::string, Awaited> awaited_;   ///< by name
    std::map<std::string, std::deque<Sample>> ways_;
};

} // namespace usar::mission
