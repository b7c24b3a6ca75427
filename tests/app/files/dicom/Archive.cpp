// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/dicom/Archive.h"

#include "support/FileBytes.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>

namespace limn::test {
namespace {

namespace fs = std::filesystem;

const char* const server = "/usr/sbin/Orthanc";
const char* const dicomWeb = "/usr/share/orthanc/plugins/libOrthancDicomWeb.so";

bool succeeds(const std::string& command) {
  const int status = std::system(command.c_str());
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// A port that nobody listens on; held until the owner goes, so that two are not one.
class FreePort {
public:
  FreePort() : m_socket(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    if (bind(m_socket, reinterpret_cast<sockaddr*>(&address), size) == 0 &&
        getsockname(m_socket, reinterpret_cast<sockaddr*>(&address), &size) == 0)
      number = ntohs(address.sin_port);
  }
  ~FreePort() { close(m_socket); }

  int number = 0;

private:
  int m_socket;
};

std::string configuration(const fs::path& folder, int httpPort, int dicomPort) {
  return "{\"Name\":\"t\",\"StorageDirectory\":\"" + folder.string() + "\",\"IndexDirectory\":\"" +
         folder.string() + "\",\"Plugins\":[\"" + dicomWeb + "\"],\"HttpPort\":" + std::to_string(httpPort) +
         ",\"DicomPort\":" + std::to_string(dicomPort) +
         ",\"DicomAet\":\"T\",\"RemoteAccessAllowed\":false,\"AuthenticationEnabled\":false,"
         "\"DicomWeb\":{\"Enable\":true,\"Root\":\"/dicom-web/\"}}";
}

} // namespace

std::string missingForArchive() {
  if (!fs::exists(server))
    return "Orthanc is not installed (package orthanc)";
  if (!fs::exists(dicomWeb))
    return "DICOMweb is not installed (package orthanc-dicomweb)";
  for (const char* tool : {"storescu", "curl"})
    if (!succeeds(std::string("command -v ") + tool + " >/dev/null"))
      return std::string(tool) + " is not installed";
  return {};
}

Archive::Archive(const fs::path& folder) : m_folder(folder) {
  {
    const FreePort http, dicom;
    m_httpPort = http.number;
    m_dicomPort = dicom.number;
  }
  fs::create_directories(folder / "kept");
  const std::string settings = (folder / "settings.json").string(), said = (folder / "log").string();
  std::ofstream(settings) << configuration(folder / "kept", m_httpPort, m_dicomPort);
  m_process = fork();
  if (m_process != 0)
    return;
  const int log = open(said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  execl(server, server, settings.c_str(), nullptr);
  _exit(127);
}

Archive::~Archive() {
  if (m_process <= 0)
    return;
  kill(m_process, SIGTERM);
  waitpid(m_process, nullptr, 0);
}

bool Archive::answers() {
  const char* limit = std::getenv("LIMN_TEST_SECONDS");
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(limit ? std::atoi(limit) : 120);
  while (std::chrono::steady_clock::now() < end) {
    if (waitpid(m_process, nullptr, WNOHANG) == m_process) {
      m_process = -1;
      return false;
    }
    if (get("/system", "application/json").find("DicomAet") != std::string::npos)
      return true;
  }
  return false;
}

bool Archive::store(const fs::path& folder) const {
  return succeeds("storescu -R +sd +r -aec T 127.0.0.1 " + std::to_string(m_dicomPort) + " '" +
                  folder.string() + "' >'" + (m_folder / "storescu").string() + "' 2>&1");
}

std::string Archive::get(const std::string& path, const std::string& accept) const {
  const fs::path answer = m_folder / "answer";
  fs::remove(answer);
  const bool isGot =
      succeeds("curl --silent --fail --noproxy '*' --max-time 60 -H 'Accept: " + accept + "' -o '" +
               answer.string() + "' 'http://127.0.0.1:" + std::to_string(m_httpPort) + path + "'");
  return isGot && fs::exists(answer) ? bytesOfFile(answer) : std::string();
}

std::string Archive::instance(const std::string& study, const std::string& series,
                              const std::string& uid) const {
  const std::string answer = get("/dicom-web/studies/" + study + "/series/" + series + "/instances/" + uid,
                                 "multipart/related; type=\"application/dicom\"");
  const std::size_t start = answer.find("\r\n\r\n"), end = answer.rfind("\r\n--");
  if (start == std::string::npos || end == std::string::npos || end < start + 4)
    return {};
  return answer.substr(start + 4, end - start - 4);
}

std::string Archive::log() const {
  return bytesOfFile(m_folder / "log") +
         (fs::exists(m_folder / "storescu") ? bytesOfFile(m_folder / "storescu") : "");
}

} // namespace limn::test
