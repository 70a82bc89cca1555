import com.eteks.sweethome3d.io.HomeFileRecorder;
import com.eteks.sweethome3d.model.*;
import java.util.*;

/** Opens a home, writes it again and opens that: prints what both hold, and the bodies of the first. Arguments: the home, where to write it. */
public class OpenAgain {
  public static void main(String[] args) throws Exception {
    HomeFileRecorder recorder = new HomeFileRecorder(9, false, null, false, true);
    Home home = recorder.readHome(args[0]);
    tell("read", home);
    recorder.writeHome(home, args[1]);
    tell("again", recorder.readHome(args[1]));
  }

  private static void tell(String word, Home home) throws Exception {
    int openings = 0, sashes = 0; double area = 0;
    for (HomePieceOfFurniture piece : home.getFurniture()) {
      if (piece instanceof HomeDoorOrWindow) { openings++; sashes += ((HomeDoorOrWindow) piece).getSashes().length; }
      if (piece.getModel() == null) throw new Exception("no model: " + piece.getName());
      try (java.io.InputStream in = piece.getModel().openStream()) { if (in.read() < 0) throw new Exception("empty model"); }
    }
    for (Room room : home.getRooms()) area += room.getArea() / 10000;
    System.out.printf(Locale.ROOT, "%s pieces %d openings %d sashes %d walls %d rooms %d levels %d area %.2f%n", word,
        home.getFurniture().size(), openings, sashes, home.getWalls().size(), home.getRooms().size(), home.getLevels().size(), area);
    if (word.equals("again")) return;
    for (HomePieceOfFurniture piece : home.getFurniture())
      if (piece.getProperty("mass") != null)
        System.out.printf(Locale.ROOT, "%s\t%.4f\t%.4f\t%.4f\t%.6f\t%.4f\t%.4f\t%.4f%n",
            Base64.getEncoder().encodeToString(piece.getProperty("id").getBytes("UTF-8")), piece.getX(), piece.getY(),
            piece.getGroundElevation(), piece.getAngle(), piece.getWidth(), piece.getDepth(), piece.getHeight());
  }
}
