// Its first code ends whatever loads it, but for a host of behaviors: as what finds the library of another version
// there.
#include <cerrno>
#include <csignal>
#include <string_view>

#include "tests/plugins/minimal_plugin.h"

namespace {

const bool crashed_in_the_program = [] {
    const std::string_view program = program_invocation_short_name;
    if (program != "usar-behavior-host")
        std::raise(SIGSEGV); // sanitizers would see a null pointer first
    return true;
}();

} // namespace

class CrashesInTheProgram : public QObject, public usar::test::MinimalPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID USAR_ROBOT_PLUGIN_IID FILE "crashes_in_the_program.json")
    Q_INTERFACES(usar::agent::RobotPlugin)
public:
    usar::Result<usar::agent::TaskPreview> preview(const std::string&,
                                                   const usar::agent::BehaviorContext& context) const override {
        if (context.task.area_in_map.empty())
            std::raise(SIGABRT);
        return usar::agent::TaskPreview{
            {{1.0, 2.0}}, 3.0, usar::Seconds(4.0), crashed_in_the_program ? "one lane" : ""};
    }
};

#include "crashes_in_the_program.moc"
